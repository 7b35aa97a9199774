/// Properties of Euler parameters: the singular J^p, the normalisation row and its multiplier.

#include "formulations/r_p.hpp"

#include "base/raise.hpp"
#include "bodies/numbers/quad.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/testing/printed_solution.hpp"
#include "formulations/testing/random_mechanism.hpp"

namespace trivium {
namespace {

using test::distance, test::Random;
using S = Quad;
using F = RP<S>;

RP<S>::Kinematics random_body(Random& random) {
  const Vector4<S> p = random.euler_parameters<S>();
  const Vector3<S> r = random.vector<S, 3>(), r_dot = random.vector<S, 3>(),
                   omega_bar = random.vector<S, 3>(2);
  return F::kinematics({}, r, r_dot, F::from_pose({}, p, omega_bar));
}
Matrix3<S> random_inertia(Random& random) {
  const Matrix3<S> A = rotation_matrix(random.euler_parameters<S>());
  const double y = random.uniform(1, 1.5), x = random.uniform(1, 1.5);
  return A * Vector3<S>(S(x), S(y), S(2)).asDiagonal() * A.transpose();
}

TEST(EulerParameterMass, HasRankThreeAndKernelP) {
  Random random(111);
  for (int n = 0; n < 50; ++n) {
    const auto body = random_body(random);
    const Matrix3<S> J = random_inertia(random);
    const Matrix<S, 4, 4> Jp = F::mass_block(body, J);
    EXPECT_LE(distance(Jp, 4 * body.G.transpose() * J * body.G), 1e-32);
    EXPECT_LE(distance(Jp * body.p, Vector4<S>::Zero()), 1e-32);
    // J^p is regular on the complement of p: G J^p G^T = 4 J_bar
    EXPECT_LE(distance(body.G * Jp * body.G.transpose(), 4 * J), 1e-31);
  }
}

TEST(EulerParameterMass, InverseOfJpPlusPPIsKnownThroughG) {
  Random random(112);
  for (int n = 0; n < 50; ++n) {
    const auto body = random_body(random);
    const Matrix3<S> J = random_inertia(random);
    const Matrix<S, 4, 4> regular = F::mass_block(body, J) + body.p * body.p.transpose();
    const Matrix<S, 4, 4> inverse =
        body.G.transpose() * J.inverse() * body.G / 4 + body.p * body.p.transpose();
    EXPECT_LE(distance(regular * inverse, Matrix<S, 4, 4>::Identity()), 1e-31);
  }
}

/// One random mechanism in r-p, its solution and its printed system.
struct Solved : test::Solved<F> {
  AugmentedSystem<F> system;

  explicit Solved(std::uint64_t seed)
      : test::Solved<F>(test::random_scene(seed, {.bodies = 3, .closings = 1, .driven = true})),
        system(augmented_system(solver.equations())) {}
  int nb() const { return mechanism.nb(); }
  VectorX<S> lambda() const { return u.lambda; }
  const F::Kinematics& body(int b) const { return solver.equations().body[b]; }
};

TEST(NormalisationMultiplier, HasItsClosedForm) {
  for (int seed = 0; seed < 10; ++seed) {
    Solved s(seed);
    for (int b = 0; b < s.nb(); ++b) {
      // lambda^p = 2 omega_bar^T J_bar omega_bar - (Phi_p p)^T lambda
      const Vector3<S>& w = s.body(b).omega_bar;
      const VectorX<S> Phi_p_p = s.system.Phi_rot.middleCols<4>(4 * b) * s.body(b).p;
      const S expected = 2 * w.dot(s.mechanism.bodies[b].inertia * w) - Phi_p_p.dot(s.lambda());
      EXPECT_LE(
          std::abs(static_cast<double>(S((s.u.lambda_internal[b] - expected) / (1 + expected * expected)))),
          1e-25);
    }
  }
}

/// Solves the printed system with the normalisation rows replaced by row_scale p^T p'' =
/// gamma_scale (-p' . p').
Unknowns<F> with_norm_row(const Solved& s, int row_scale, int gamma_scale) {
  AugmentedSystem<F> other = s.system;
  other.P *= S(row_scale);
  other.gamma_internal *= S(gamma_scale);
  const VectorX<S> x = DenseSolver<S>(other.matrix()).solve(other.right_side());
  return split_unknowns<F>(x, s.nb(), s.mechanism.nc());
}

double largest_difference(const Solved& s, const Unknowns<F>& other) {
  double worst = distance(other.lambda, s.u.lambda);
  for (int b = 0; b < s.nb(); ++b)
    raise(worst, distance(F::to_angular_acceleration(s.body(b), other.body[b].q_ddot),
                          F::to_angular_acceleration(s.body(b), s.u.body[b].q_ddot)));
  return worst;
}

TEST(NormalisationRow, MayBeScaledIfItsRightSideIsToo) {
  for (int seed = 0; seed < 5; ++seed) {
    Solved s(seed);
    EXPECT_LE(largest_difference(s, with_norm_row(s, 1, 1)), 1e-22);
    EXPECT_LE(largest_difference(s, with_norm_row(s, 2, 2)), 1e-22);
  }
}

TEST(NormalisationRow, OfOneFormWithTheRightSideOfTheOtherGivesAnotherLambda) {
  // P = p^T with gamma^p = -2 p' . p', as in some notes: wrong wherever Phi_p p is not 0
  for (int seed = 0; seed < 5; ++seed) {
    Solved s(seed);
    EXPECT_GE(largest_difference(s, with_norm_row(s, 1, 2)), 1e-6);
  }
}

TEST(RangeSpaceElimination, WithJpPlusPPIsExact) {
  for (int seed = 0; seed < 5; ++seed) {
    Solved s(seed);
    // H q'' + Phi^T lambda + P^T lambda^p = tau_hat + p gamma^p, with the regular H = J^p + p p^T
    const int nb = s.nb(), nc = s.mechanism.nc();
    MatrixX<S> inverse = MatrixX<S>::Zero(7 * nb, 7 * nb), rows = MatrixX<S>::Zero(nc + nb, 7 * nb);
    VectorX<S> force(7 * nb), right(nc + nb);
    rows.topRows(nc) << s.system.Phi_r, s.system.Phi_rot;
    rows.bottomRightCorner(nb, 4 * nb) = s.system.P;
    right << s.system.gamma, s.system.gamma_internal;
    for (int b = 0; b < nb; ++b) {
      const auto& [mass, J] = s.mechanism.bodies[b];
      const auto& k = s.body(b);
      inverse.block<3, 3>(3 * b, 3 * b) = Matrix3<S>::Identity() / mass;
      inverse.block<4, 4>(3 * nb + 4 * b, 3 * nb + 4 * b) =
          k.G.transpose() * J.inverse() * k.G / 4 + k.p * k.p.transpose();
      force.segment<3>(3 * b) = s.system.F_applied.segment<3>(3 * b);
      force.segment<4>(3 * nb + 4 * b) = s.system.tau.segment<4>(4 * b) + k.p * s.system.gamma_internal[b];
    }
    const MatrixX<S> W = inverse * rows.transpose();
    const VectorX<S> multipliers = DenseSolver<S>(rows * W).solve(rows * (inverse * force) - right);
    const double size = 1 + static_cast<double>(multipliers.cwiseAbs().maxCoeff());
    EXPECT_LE(distance(multipliers.head(nc), s.lambda()), 1e-24 * size);
    EXPECT_LE(distance(multipliers.tail(nb), s.u.lambda_internal), 1e-24 * size);
    const VectorX<S> q_ddot = inverse * force - W * multipliers;
    for (int b = 0; b < nb; ++b) {
      EXPECT_LE(distance(q_ddot.segment<4>(3 * nb + 4 * b), s.u.body[b].q_ddot), 1e-24 * size);
      EXPECT_LE(distance(q_ddot.segment<3>(3 * b), s.u.body[b].r_ddot), 1e-24 * size);
    }
  }
}

}  // namespace
}  // namespace trivium
