/// The solver along the graph and the printed system say the same: accelerations, Phi^T lambda, rank, which
/// multipliers are unique, and those that are.

#include "formulations/acceleration_solver.hpp"

#include <filesystem>

#include "bodies/testing.hpp"
#include "formulations/solved_scene.hpp"
#include "formulations/test_mechanisms.hpp"
#include "scenes/generators.hpp"
#include "scenes/scene_file.hpp"
#include "scenes/test_scenes.hpp"

namespace trivium {
namespace {

using test::for_all, test::Solved;

template <class F>
class StructuredSolver : public testing::Test {};
TYPED_TEST_SUITE(StructuredSolver, test::AllFormulations<double>, test::FormulationNames);

/// A scene solved both ways.
template <class F>
struct SolvedTwice {
  using S = typename F::Scalar;

  Solved<F> printed;
  std::vector<BodyState<F>> bodies;
  AccelerationSolver<F> structured;
  PhysicalSolution<S> by_print, by_graph;

  explicit SolvedTwice(const scenes::Scene& scene)
      : printed(scene),
        bodies(to_coordinates<F>(printed.mechanism, printed.state, {})),
        structured(printed.mechanism),
        by_print(printed.solver.physical(printed.x)) {
    structured.solve(bodies, printed.state.t);
    for (int b = 0; b < printed.mechanism.nb(); ++b) {
      by_graph.r_ddot.push_back(structured.r_ddot(b));
      by_graph.omega_bar_dot.push_back(structured.omega_bar_dot(b));
    }
    by_graph.lambda = structured.lambda();
  }

  double accelerations_apart() const { return acceleration_distance(printed.rows, by_graph, by_print).all; }
  double lambda_apart() const { return lambda_distance(printed.rows, by_graph.lambda, by_print.lambda); }
  /// Of Phi^T lambda, relative to the largest force of a row.
  double forces_apart() const {
    const auto& eom = printed.solver.equations();
    double largest = 0;
    std::vector<Vector<S, 3 + F::rotational_unknowns>> difference(eom.nb() + 1);
    for (auto& d : difference) d.setZero();
    for (int k = 0; k < eom.nc(); ++k) {
      const auto add = [&](int body, const auto& r, const auto& rot) {
        Vector<S, 3 + F::rotational_unknowns> gradient;
        gradient << r.transpose(), rot.transpose();
        difference[body] += (by_graph.lambda[k] - by_print.lambda[k]) * gradient;
        largest = std::max(largest, static_cast<double>(S((by_print.lambda[k] * gradient).norm())));
      };
      add(eom.pair[k].i, eom.row[k].r_i, eom.row[k].rot_i);
      add(eom.pair[k].j, eom.row[k].r_j, eom.row[k].rot_j);
    }
    double apart = 0;
    for (int b = 0; b < eom.nb(); ++b) apart = std::max(apart, static_cast<double>(S(difference[b].norm())));
    return largest > 0 ? apart / largest : apart;
  }
};

template <class F>
void expect_agreement(const SolvedTwice<F>& s, const std::string& what) {
  using S = typename F::Scalar;
  const double u = static_cast<double>(unit_roundoff<S>()), kappa = s.printed.rows.kappa;
  EXPECT_EQ(s.structured.rank(), s.printed.rows.rank) << what;
  EXPECT_LE(s.accelerations_apart(), 100 * u * kappa) << what;
  EXPECT_LE(s.lambda_apart(), 100 * u * kappa) << what;
  EXPECT_LE(s.forces_apart(), 1000 * u * kappa) << what;
}

test::MechanismOptions options_of(std::uint64_t seed) {
  test::MechanismOptions o;
  o.bodies = 1 + static_cast<int>(seed % 6);
  o.closings = static_cast<int>(seed / 2 % 3);
  o.doubled = static_cast<int>(seed / 5 % 3);
  o.driven = o.doubled == 0 && seed % 2 == 0;
  o.mass_decades = seed % 7 == 0 ? 3 : 0.5;
  return o;
}

TYPED_TEST(StructuredSolver, AgreesWithThePrintedSystem) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SolvedTwice<TypeParam> s(test::random_scene(seed, options_of(seed)));
    expect_agreement(s, "seed " + std::to_string(seed));
    EXPECT_EQ(s.structured.unique(), s.printed.rows.unique) << seed;
  }
}

template <class S, template <class> class F>
void expect_agreement_in(std::uint64_t seeds) {
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    SolvedTwice<F<S>> s(test::random_scene(seed, options_of(seed)));
    expect_agreement(s, std::string(F<S>::name) + " seed " + std::to_string(seed));
    EXPECT_EQ(s.structured.unique(), s.printed.rows.unique) << seed;
  }
}
template <class S>
void expect_agreement_in_all(std::uint64_t seeds) {
  expect_agreement_in<S, ROmega>(seeds);
  expect_agreement_in<S, RP>(seeds);
  expect_agreement_in<S, REpsilon>(seeds);
}
TEST(StructuredSolver, AgreesWithThePrintedSystemInFloat) { expect_agreement_in_all<float>(40); }
TEST(StructuredSolver, AgreesWithThePrintedSystemInQuad) { expect_agreement_in_all<Quad>(20); }

TYPED_TEST(StructuredSolver, AgreesOnTheCatalogue) {
  for (const auto& entry : std::filesystem::directory_iterator(TRIVIUM_SCENES_DIR)) {
    const auto& path = entry.path();
    if (path.extension() != ".json" || path.stem().extension() == ".schema" || path.stem() == "n_four_bar_40")
      continue;
    SolvedTwice<TypeParam> s(scenes::read_scene_file(path));
    expect_agreement(s, path.stem().string());
    EXPECT_EQ(s.structured.unique(), s.printed.rows.unique) << path.stem();
  }
}

/// The largest relative difference of a joint's multipliers, forces and torques apart.
template <class S>
double joints_apart(const Mechanism<S>& mechanism, const VectorX<S>& lambda, const VectorX<Quad>& exact) {
  double worst = 0;
  for (const Joint<S>& joint : mechanism.joints) {
    Quad difference(0), size(0);
    for (int k = joint.first_row; k < joint.first_row + joint.rows; ++k) {
      const Quad d = Quad(lambda[k]) - exact[k];
      difference += d * d;
      size += exact[k] * exact[k];
    }
    worst = std::max(worst, std::sqrt(static_cast<double>(Quad(difference / size))));
  }
  return worst;
}

/// Light and heavy bars by turns, a heavy one at the tip.
scenes::Scene uneven_chain(int n, double ratio) {
  scenes::Scene scene = scenes::chain(n);
  for (int b = 0; b < n; ++b) {
    if ((n - b) % 2 == 0) continue;
    scene.bodies[b].mass *= ratio;
    for (double& moment : std::get<scenes::Vector3>(scene.bodies[b].inertia)) moment *= ratio;
  }
  return scene;
}

template <template <class> class F>
double error_of_lambda(const scenes::Scene& scene) {
  const auto solve = [&]<class S>(S) {
    const auto mechanism = make_mechanism<S>(scene);
    const auto state = make_state<S>(scene);
    AccelerationSolver<F<S>> solver(mechanism);
    solver.solve(to_coordinates<F<S>>(mechanism, state, {}), state.t);
    return solver.lambda();
  };
  return joints_apart(make_mechanism<double>(scene), solve(0.0), solve(Quad(0)));
}

TEST(LongChain, LambdaIsRightToTwelveDigitsAtAMassRatioOfABillion) {
  const auto scene = uneven_chain(1000, 1e9);
  EXPECT_LE(error_of_lambda<ROmega>(scene), 1e-12);
  EXPECT_LE(error_of_lambda<RP>(scene), 1e-12);
  EXPECT_LE(error_of_lambda<REpsilon>(scene), 1e-12);
}

TEST(LongChain, LambdaIsRightToTwelveDigitsWithoutAxialInertia) {
  scenes::Scene scene = scenes::chain(1000);
  for (auto& body : scene.bodies) std::get<scenes::Vector3>(body.inertia)[0] = 0;
  EXPECT_LE(error_of_lambda<ROmega>(scene), 1e-12);
  EXPECT_LE(error_of_lambda<RP>(scene), 1e-12);
  EXPECT_LE(error_of_lambda<REpsilon>(scene), 1e-12);
}

TEST(StructuredSolver, NamesTheBodyWhoseMotionHasNoInertia) {
  scenes::Scene scene;
  scene.bodies = {test::body("rod", 1, {0, 1, 1})};
  scene.constraints = {test::joint(scenes::ConstraintType::spherical, "ball",
                                   test::side(scenes::ground, scenes::Vector3{}),
                                   test::side(0, scenes::Vector3{1, 0, 0}))};
  scene.bodies[0].position = {-1, 0, 0};
  const auto mechanism = make_mechanism<double>(scene);
  const auto state = make_state<double>(scene);
  AccelerationSolver<ROmega<double>> solver(mechanism);
  try {
    solver.solve(to_coordinates<ROmega<double>>(mechanism, state, {}), 0);
    ADD_FAILURE() << "a free spin without inertia has no acceleration";
  } catch (const ModelError& error) {
    EXPECT_NE(std::string(error.what()).find("body \"rod\""), std::string::npos) << error.what();
  }
}

TEST(StructuredSolver, CorrectionsCoverTheErrorOfTheUnrefinedSolution) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    using F = ROmega<double>;
    SolvedTwice<F> s(test::random_scene(seed, options_of(seed)));
    SolvedTwice<ROmega<Quad>> exact(test::random_scene(seed, options_of(seed)));
    s.structured.solve(s.bodies, s.printed.state.t, Refinement::none);
    const VectorX<double> rough = s.structured.lambda();
    s.structured.refine();
    const double error =
        lambda_distance(s.printed.rows, VectorX<Quad>(scalar_cast<Quad>(rough)), exact.by_graph.lambda);
    EXPECT_GE(100 * (s.structured.corrections().lambda + 1e-16), error) << seed;
  }
}

}  // namespace
}  // namespace trivium
