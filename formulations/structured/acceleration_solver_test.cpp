/// The structured solver and the printed system have the same solution.

#include "formulations/structured/acceleration_solver.hpp"

#include <filesystem>

#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/testing/properties.hpp"
#include "formulations/testing/printed_and_structured.hpp"
#include "formulations/testing/solve_scene.hpp"
#include "scenes/format/scene_file.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/catalogue_scene.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

using test::SolvedTwice;

/// The scene in units of length and mass that are smaller by these factors; its only effects are gravity.
scenes::Scene in_units(scenes::Scene scene, double length, double mass) {
  const auto scale = [](scenes::Vector3& v, double by) {
    for (double& x : v) x *= by;
  };
  for (scenes::Body& body : scene.bodies) {
    body.mass *= mass;
    const double moment = mass * length * length;
    if (auto* diagonal = std::get_if<scenes::Vector3>(&body.inertia)) scale(*diagonal, moment);
    if (auto* full = std::get_if<scenes::Matrix3>(&body.inertia))
      for (scenes::Vector3& row : *full) scale(row, moment);
    scale(body.position, length);
    scale(body.velocity, length);
  }
  for (scenes::Constraint& c : scene.constraints) {
    if (c.i.point) scale(*c.i.point, length);
    if (c.j.point) scale(*c.j.point, length);
    c.distance *= length;
    const double f = c.type == basic_type<DP1> ? 1 : c.type == basic_type<D> ? length * length : length;
    c.f = TimeFunction::Product{{c.f, f}};
  }
  std::erase_if(scene.effects, [](const auto& e) { return !std::holds_alternative<Gravity<double>>(e); });
  for (auto& effect : scene.effects) std::get<Gravity<double>>(effect).acceleration *= length;
  return scene;
}
/// The factor of a row's unit: dp1 is a number, dp2 and cd are lengths, d is a length squared.
double unit_of(const BasicConstraint<double>& row, double length) {
  if (std::holds_alternative<D<double>>(row)) return length * length;
  return std::holds_alternative<DP2<double>>(row) || std::holds_alternative<CD<double>>(row) ? length : 1;
}

template <class F>
class StructuredSolver : public testing::Test {};
TYPED_TEST_SUITE(StructuredSolver, test::AllFormulations<double>, test::FormulationNames);

TYPED_TEST(StructuredSolver, AgreesWithThePrintedSystem) { test::expect_agreement_on<TypeParam>(150); }

TYPED_TEST(StructuredSolver, IsNotMadeOfATemporary) {
  static_assert(std::is_constructible_v<AccelerationSolver<TypeParam>, Mechanism<double>&>);
  static_assert(!std::is_constructible_v<AccelerationSolver<TypeParam>, Mechanism<double>>);
}

TYPED_TEST(StructuredSolver, AgreesOnTheCatalogue) {
  for (const auto& entry : std::filesystem::directory_iterator(TRIVIUM_SCENES_DIR)) {
    const auto& path = entry.path();
    if (path.extension() != ".json" || path.stem() == "n_four_bar_40") continue;
    test::expect_agreement<TypeParam>(scenes::read_scene_file(path), path.stem().string());
  }
}

TYPED_TEST(StructuredSolver, MinimumNormIsThatOfThePrintedSystem) {
  for (const char* name : {"four_bar", "bricard", "door"}) {
    test::SolvedTwice<TypeParam> s(test::catalogue_scene(name));
    ASSERT_LT(s.structured.rank(), s.mechanism.nc()) << name;
    const VectorX<double> least = s.structured.minimum_norm_lambda(), printed = s.by_print.lambda;
    EXPECT_LE((least - printed).norm(), 1e-10 * (1e-6 + printed.norm())) << name;
  }
}

// No decision compares numbers of different units and the order of elimination is fixed. Units that differ by
// powers of two therefore change no bit, and balancing the system would be useless.
TYPED_TEST(StructuredSolver, UnitsChangeNoBit) {
  const double length = 0x1p10, mass = 0x1p-7;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const scenes::Scene scene = in_units(test::varied_scene(seed), 1, 1);
    const auto solve = [&](const scenes::Scene& of, const auto& use) {
      const auto mechanism = make_mechanism<double>(of);
      AccelerationSolver<TypeParam> solver(mechanism);
      solver.solve(to_coordinates<TypeParam>(mechanism, make_state<double>(of), {}), 0);
      use(mechanism, solver);
    };
    solve(scene, [&](const auto& mechanism, auto& solver) {
      solve(in_units(scene, length, mass), [&](const auto&, auto& other) {
        for (int b = 0; b < mechanism.nb(); ++b) {
          EXPECT_EQ(other.r_ddot(b), length * solver.r_ddot(b)) << seed;
          EXPECT_EQ(other.omega_bar_dot(b), solver.omega_bar_dot(b)) << seed;
        }
        for (int k = 0; k < mechanism.nc(); ++k)
          EXPECT_EQ(other.lambda()[k],
                    mass * length * length / unit_of(mechanism.rows[k], length) * solver.lambda()[k])
              << seed;
        EXPECT_EQ(other.unique(), solver.unique()) << seed;
      });
    });
  }
}

TEST(StructuredSolver, AgreesWhereManyClosingsMeet) {
  for (std::uint64_t seed = 2900; seed < 3000; ++seed) {
    test::MechanismOptions o;
    o.bodies = 1 + static_cast<int>(seed % 12);
    o.closings = static_cast<int>(seed / 3 % 5);
    o.doubled = static_cast<int>(seed / 7 % 3);
    // seed 2953: a loop in which only rows of the tree depend on absolute motion
    test::expect_agreement<ROmega<double>>(test::random_scene(seed, o), "seed " + std::to_string(seed));
  }
}

TEST(StructuredSolver, NamesTheBodyWhoseMotionHasNoInertia) {
  scenes::Scene scene;
  scene.bodies = {test::body("rod", 1, {0, 1, 1})};
  scene.constraints = {test::joint(JointType::spherical, "ball",
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

/// Three bodies that hang on each other by rods, the light one between the other two. The light
/// body is eliminated after the heavy one, whose inertia it takes up and beside which its own is small.
scenes::Scene hung_on_a_light_body(double light, double heavy) {
  using scenes::Vector3;
  const auto body = [](const char* name, double mass, const Vector3& position) {
    scenes::Body b = test::body(name, mass, {mass, 2 * mass, 2.5 * mass}, position);
    b.velocity = {0.1, 0.2, -0.3};
    b.angular_velocity = {0.3, -0.5, 0.7};
    return b;
  };
  scenes::Scene scene;
  scene.bodies = {body("upper", 1, {1, 0, 0}), body("light", light, {2, 0.5, 0}),
                  body("heavy", heavy, {3, 0, 0.5})};
  for (int b = 0; b < 3; ++b) {
    const Vector3 on_i = b == 0 ? Vector3{} : Vector3{0.1, 0.2, 0.3}, on_j{-0.2, 0.1, -0.3};
    auto rod = test::joint(JointType::distance, "rod " + std::to_string(b), test::side(b - 1, on_i),
                           test::side(b, on_j));
    double squared = 0;
    for (int k = 0; k < 3; ++k) {
      const double from = on_i[k] + (b == 0 ? 0 : scene.bodies[b - 1].position[k]);
      squared += std::pow(scene.bodies[b].position[k] + on_j[k] - from, 2);
    }
    rod.distance = std::sqrt(squared);
    scene.constraints.push_back(rod);
  }
  scene.effects.push_back(test::gravity());
  test::project_velocities(scene);
  return scene;
}
TEST(StructuredSolver, RefinesUntilALightBodyThatHoldsAHeavyOneIsRight) {
  for (const auto& [light, heavy] : {std::pair(1e-2, 1e2), {1e-4, 1e4}, {1e-2, 1e6}}) {
    const scenes::Scene scene = hung_on_a_light_body(light, heavy);
    const std::string what = "mass ratio " + std::to_string(heavy / light);
    test::expect_agreement<ROmega<double>>(scene, what);
    test::expect_agreement<RP<double>>(scene, what);
    test::expect_agreement<REpsilon<double>>(scene, what);
  }
}

TEST(StructuredSolver, CorrectionsCoverTheErrorOfTheUnrefinedSolution) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    using F = ROmega<double>;
    SolvedTwice<F> s(test::varied_scene(seed));
    const auto exact = test::solve_scene<Quad>(test::varied_scene(seed), {{"r-omega"}, {}}, false);
    s.structured.solve(s.bodies, s.state.t, Refinement::none);
    const VectorX<double> rough = s.structured.lambda();
    s.structured.refine();
    const double error = lambda_distance(s.printed.rows, VectorX<Quad>(scalar_cast<Quad>(rough)),
                                         exact.formulations.front().solution.lambda);
    EXPECT_GE(100 * (s.structured.corrections().lambda + 1e-16), error) << seed;
  }
}

/// A body at 20 000 turns a minute about its own axis, held at two points of the axis by cd rows.
scenes::Scene fast_rotor() {
  scenes::Scene scene;
  scene.name = "rotor";
  scene.bodies = {test::body("rotor", 1, {0.02, 0.02, 0.03})};
  // an orientation in which no element of p is 0
  scene.bodies[0].orientation = scenes::AxisAngle{{0.36, 0.48, 0.8}, 0.7};
  scene.bodies[0].angular_velocity = {0, 0, 2094.4};
  const Vector3<double> a = rotation_matrix(make_state<double>(scene).pose[0].p) * Vector3<double>(0, 0, 0.5);
  for (const double end : {1.0, -1.0})
    for (int k = 0; k < 3; ++k) {
      if (end < 0 && k == 2) continue;
      auto row = test::joint(basic_type<CD>, fmt::format("{}{}", end, k),
                             test::side(scenes::ground, scenes::Vector3{end * a[0], end * a[1], end * a[2]}),
                             test::side(0, scenes::Vector3{0, 0, end * 0.5}));
      row.direction = {k == 0 ? 1.0 : 0.1, k == 1 ? 1.0 : 0.2, k == 2 ? 1.0 : 0.3};
      scene.constraints.push_back(row);
    }
  scene.effects = {test::gravity()};
  return scene;
}

// the printed form of r-p adds terms of the size |omega|^2 that cancel
TEST(AccelerationSolver, LosesNothingAtAFastSpinInRP) {
  const scenes::Scene scene = fast_rotor();
  const auto exact = test::solve_scene<Quad>(scene, {{"r-omega"}, {}}, false).formulations.front().solution;
  const SolvedTwice<RP<double>> s(scene);
  const auto error = [&](const VectorX<double>& lambda) {
    return lambda_distance(s.printed.rows, VectorX<Quad>(scalar_cast<Quad>(lambda)), exact.lambda);
  };
  EXPECT_LE(error(s.by_graph.lambda), 1e-14);
  EXPECT_GE(error(s.by_print.lambda), 1e-12);
  EXPECT_LE(
      static_cast<double>((scalar_cast<Quad>(s.by_graph.omega_bar_dot[0]) - exact.omega_bar_dot[0]).norm()),
      1e-12);
}

}  // namespace
}  // namespace trivium
