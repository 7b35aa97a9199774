/// Laws that a solution of the augmented system must satisfy, on random mechanisms.

#include "formulations/printed/augmented_solver.hpp"

#include <Eigen/QR>
#include <type_traits>

#include "base/raise.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/joint_reaction.hpp"
#include "formulations/testing/printed_solution.hpp"
#include "formulations/testing/random_mechanism.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

using test::distance, test::for_all, test::Solved;

test::MechanismOptions draw_options() {
  test::MechanismOptions options;
  options.bodies = *rc::gen::inRange(1, 5);
  options.closings = *rc::gen::inRange(0, 2);
  options.doubled = *rc::gen::inRange(0, 2);
  options.driven = *rc::gen::arbitrary<bool>() && options.doubled == 0;
  return options;
}
scenes::Scene draw_scene() {
  const auto options = draw_options();
  return test::random_scene(*rc::gen::inRange(0, 100000), options);
}

template <class F>
class Solutions : public testing::Test {};
TYPED_TEST_SUITE(Solutions, test::AllFormulations<double>, test::FormulationNames);

/// The largest force of a row, as the scale of rounding errors.
template <class F>
double force_scale(const Solved<F>& s) {
  double scale = 1;
  for (std::size_t k = 0; k < s.mechanism.rows.size(); ++k) {
    const auto& row = s.solver.equations().row[k];
    const double gradient = row.r_i.norm() + row.r_j.norm() + row.rot_i.norm() + row.rot_j.norm();
    raise(scale, std::abs(s.u.lambda[k]) * gradient);
  }
  return scale;
}

TYPED_TEST(Solutions, AreNotAskedOfTemporaries) {
  using M = Mechanism<double>;
  using State = const MechanismState<double>&;
  static_assert(std::is_constructible_v<AugmentedSolver<TypeParam>, M&, State, RowAnalysis&>);
  static_assert(!std::is_constructible_v<AugmentedSolver<TypeParam>, M, State, RowAnalysis&>);
  static_assert(!std::is_constructible_v<AugmentedSolver<TypeParam>, M&, State, RowAnalysis>);
  static_assert(!std::is_constructible_v<AugmentedEquations<TypeParam>, M, State, RowAnalysis>);
}

TYPED_TEST(Solutions, MatrixFreeResidualIsAtRoundingLevel) {
  using F = TypeParam;
  for_all(
      [] {
        Solved<F> s(draw_scene());
        const MatrixFreeResidual residual = s.solver.residual(s.solver.expand(s.solver.solve_reduced()));
        RC_ASSERT(residual.bodies <= 1e-13);
        RC_ASSERT(residual.rows <= 1e-13);
        // the omitted rows are satisfied too, to the consistency of the scene
        RC_ASSERT(residual.dependent_rows <= 1e-11 * s.rows.kappa);
      },
      60);
}

TYPED_TEST(Solutions, MatrixFreeResidualSeesAWrongSolution) {
  using F = TypeParam;
  Solved<F> s(test::random_scene(5));
  for (const Eigen::Index k : {Eigen::Index(0), s.x.size() / 2, s.x.size() - 1}) {
    VectorX<double> wrong = s.x;
    wrong[k] += 1e-6 * (1 + std::abs(wrong[k]));
    const MatrixFreeResidual residual = s.solver.residual(wrong);
    EXPECT_GE(std::max(residual.bodies, residual.rows), 1e-10) << k;
  }
  VectorX<double> undefined = s.x;
  undefined[0] = std::nan("");
  const MatrixFreeResidual residual = s.solver.residual(undefined);
  EXPECT_TRUE(std::isnan(residual.bodies));
}

TYPED_TEST(Solutions, BalanceTheMomentumOfEveryBody) {
  using F = TypeParam;
  for_all(
      [] {
        const Solved<F> s(draw_scene());
        const auto& eom = s.solver.equations();
        const auto applied = applied_wrenches(s.mechanism, eom.body, eom.t);
        const PhysicalSolution<double> physical = s.solver.accelerations_of(s.x);
        for (int b = 0; b < s.mechanism.nb(); ++b) {
          Vector3<double> force = applied[b].F, torque = eom.body[b].A * applied[b].n_bar;
          for (const auto& joint : s.mechanism.joints)
            for (const End end : {End::i, End::j}) {
              if ((end == End::i ? joint.i : joint.j) != b) continue;
              const Reaction<double> reaction = joint_reaction<F>(eom, joint, s.u.lambda, end);
              force += reaction.force;
              torque += reaction.torque;
            }
          const auto& [mass, J] = s.mechanism.bodies[b];
          const Vector3<double>& w = s.state.twist[b].omega_bar;
          const double scale = force_scale(s);
          // Newton: m r'' = sum of forces. Euler: J_bar omega_bar' + omega_bar x J_bar omega_bar = sum of
          // torques.
          RC_ASSERT(distance(mass * physical.r_ddot[b], force) <= 1e-12 * scale);
          RC_ASSERT(distance(J * physical.omega_bar_dot[b] + w.cross(J * w),
                             eom.body[b].A.transpose() * torque) <= 1e-11 * scale);
        }
      },
      60);
}

TYPED_TEST(Solutions, ReactionsOfEveryJointDoNoVirtualWork) {
  using F = TypeParam;
  for_all(
      [] {
        const Solved<F> s(draw_scene());
        const auto& eom = s.solver.equations();
        const TangentSystem tangent = tangent_system(s.mechanism, s.state);
        for (const auto& joint : s.mechanism.joints) {
          // a random displacement, projected so that this joint's own rows allow it
          VectorX<double> step =
              test::Random(joint.first_row + 1).vector<double, 24>().head(6 * s.mechanism.nb());
          const MatrixX<double> Phi = tangent.Phi.middleRows(joint.first_row, joint.rows);
          Eigen::CompleteOrthogonalDecomposition<MatrixX<double>> rows(Phi);
          for (int pass = 0; pass < 2; ++pass) step -= rows.solve(Phi * step);
          double work = 0;
          for (const End end : {End::i, End::j}) {
            const int b = end == End::i ? joint.i : joint.j;
            if (b == s.mechanism.ground()) continue;
            const Reaction<double> reaction = joint_reaction<F>(eom, joint, s.u.lambda, end);
            work += reaction.force.dot(step.segment<3>(6 * b)) +
                    reaction.torque.dot(eom.body[b].A * step.segment<3>(6 * b + 3));
          }
          RC_ASSERT(std::abs(work) <= 1e-12 * force_scale(s));
        }
      },
      60);
}

TYPED_TEST(Solutions, LambdaHasMinimumNormAmongTheEquivalent) {
  using F = TypeParam;
  for (int seed = 0; seed < 20; ++seed) {
    const Solved<F> s(test::random_scene(seed, {.bodies = 3, .closings = 1, .doubled = 1}));
    ASSERT_FALSE(s.rows.dependent.empty());
    const VectorX<double> E_lambda = s.rows.E.cwiseProduct(s.u.lambda);
    const MatrixX<double> EN = s.rows.E.asDiagonal() * s.rows.null_basis;
    EXPECT_LE((EN.transpose() * E_lambda).cwiseAbs().maxCoeff(), 1e-12 * E_lambda.norm());
    // the same forces as with the multipliers of the dependent rows set to zero
    const Unknowns<F> plain = s.solver.split(s.solver.expand(s.solver.solve_reduced()));
    const TangentSystem tangent = tangent_system(s.mechanism, s.state);
    for (int k : s.rows.dependent) EXPECT_EQ(plain.lambda[k], 0);
    EXPECT_LE(distance(tangent.Phi.transpose() * plain.lambda, tangent.Phi.transpose() * s.u.lambda),
              1e-11 * force_scale(s));
    for (std::size_t k = 0; k < s.rows.unique.size(); ++k)
      if (s.rows.unique[k]) {
        EXPECT_EQ(plain.lambda[k], s.u.lambda[k]);
      }
    EXPECT_LE(E_lambda.norm(), s.rows.E.cwiseProduct(plain.lambda).norm() * (1 + 1e-12));
  }
}

}  // namespace
}  // namespace trivium
