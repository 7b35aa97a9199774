/// Chains, rings, ladders and trees of many bodies: straight, random and folded. lambda of one state, and a
/// short motion.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "bodies/numbers/quad.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/structured/acceleration_solver.hpp"
#include "formulations/structured_side_by_side.hpp"
#include "scenes/building.hpp"
#include "scenes/generators.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/random_draw.hpp"
#include "scenes/scene_state.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/known_motions.hpp"
#include "validation/hard/methods.hpp"
#include "validation/hard/solved_state.hpp"

namespace trivium::hard {

namespace {

using building::body, building::joint, building::side;
using scenes::plain, scenes::Scene, scenes::Vector3;

constexpr int many = 1000, some = 100;
const Vector3 y{0, 1, 0}, back{-0.5, 0, 0}, front{0.5, 0, 0};

scenes::RandomDraw random_from(double seed) {
  return scenes::RandomDraw(static_cast<std::uint64_t>(std::llround(std::abs(seed))));
}

/// A chain of n bars in a plane, each at its own angle [rad] to the x axis.
Scene plane_chain(const std::string& name, int n, const std::function<double(int)>& angle) {
  Scene scene;
  scene.name = name;
  double x = 0, z = 0;
  for (int k = 0; k < n; ++k) {
    const double turn = angle(k), c = std::cos(turn), s = -std::sin(turn);
    scene.bodies.push_back(
        body(fmt::format("bar_{}", k + 1), 1, {0.01, 0.1, 0.1}, {x + c / 2, 0, z + s / 2}));
    scene.bodies.back().orientation = scenes::AxisAngle{y, turn};
    scene.constraints.push_back(joint(JointType::revolute, fmt::format("J{}", k + 1),
                                      side(k == 0 ? scenes::ground : k - 1, k == 0 ? Vector3{} : front, y),
                                      side(k, back, y)));
    x += c;
    z += s;
  }
  scene.effects = {building::gravity()};
  return scene;
}

/// A zigzag: at the angle 0 it is straight, at nearly pi / 2 folded.
Scene zigzag(int n, double angle) {
  return plane_chain(fmt::format("zigzag_{:g}", angle), n,
                     [angle](int k) { return k % 2 == 0 ? angle : -angle; });
}

Scene random_chain(int n, double seed) {
  scenes::RandomDraw random = random_from(seed);
  return plane_chain(fmt::format("random_chain_{:g}", seed), n,
                     [&](int) { return std::numbers::pi * random.uniform(-1, 1); });
}

/// A ring of bars on spherical joints through these points [m]. It turns as a whole at 0.8 rad/s about the y
/// axis of a revolute in the middle of its first bar.
Scene ring_through(const std::string& name, const std::vector<trivium::Vector3<double>>& points) {
  using V = trivium::Vector3<double>;
  Scene scene;
  scene.name = name;
  const int n = static_cast<int>(points.size());
  const V middle = (points[0] + points[1]) / 2, omega(0, 0.8, 0);
  std::vector<double> half;
  for (int k = 0; k < n; ++k) {
    const V &from = points[k], &to = points[(k + 1) % n], r = (from + to) / 2 - middle;
    half.push_back((to - from).norm() / 2);
    const auto turn = Eigen::Quaterniond::FromTwoVectors(V::UnitX(), to - from);
    scenes::Body bar = body(fmt::format("bar_{}", k + 1), 1, {0.01, 0.1, 0.1}, plain(r));
    bar.orientation = scenes::EulerParameters{{turn.w(), turn.x(), turn.y(), turn.z()}};
    bar.velocity = plain(V(omega.cross(r)));
    bar.angular_velocity = plain(V(turn.conjugate() * omega));
    scene.bodies.push_back(bar);
  }
  const auto first = Eigen::Quaterniond::FromTwoVectors(V::UnitX(), points[1] - points[0]);
  scene.constraints = {joint(JointType::revolute, "hold", side(scenes::ground, Vector3{}, y),
                             side(0, Vector3{}, plain(V(first.conjugate() * V::UnitY()))))};
  for (int k = 0; k < n; ++k)
    scene.constraints.push_back(joint(JointType::spherical, fmt::format("J{}", k + 1),
                                      side(k, Vector3{half[k], 0, 0}),
                                      side((k + 1) % n, Vector3{-half[(k + 1) % n], 0, 0})));
  scene.effects = {building::gravity()};
  return scene;
}

/// A star: a regular polygon in the x-z plane whose corners are alternately farther out and farther in by
/// this share of its radius. At nearly 1 its bars are folded.
Scene star_ring(int n, double depth) {
  std::vector<trivium::Vector3<double>> points;
  for (int k = 0; k < n; ++k) {
    const double corner = 2 * std::numbers::pi * k / n,
                 radius = n / (2 * std::numbers::pi) * (1 + (k % 2 == 0 ? depth : -depth));
    points.emplace_back(radius * std::cos(corner), 0, radius * std::sin(corner));
  }
  return ring_through(fmt::format("star_ring_{:g}", depth), points);
}

/// Through random points in a cube.
Scene random_ring(int n, double seed) {
  scenes::RandomDraw random = random_from(seed);
  std::vector<trivium::Vector3<double>> points(n);
  for (auto& point : points)
    for (double& x : point) x = random.uniform(-1, 1);
  return ring_through(fmt::format("random_ring_{:g}", seed), points);
}

/// The N-four-bar ladder with its rods at this angle [rad] to their base: at pi / 2 upright, at nearly 0
/// folded.
Scene folded_ladder(int n, double angle) {
  Scene scene = scenes::ladder(n);
  scene.name = fmt::format("folded_ladder_{:g}", angle);
  MechanismState<double> state = state_of_size(scene.bodies.size());
  set_ladder(state, n, angle, -1);
  set_state(scene, state);
  return scene;
}

/// A ladder whose couplers are of random length, its rods at 1 rad to their base.
Scene random_ladder(int n, double seed) {
  scenes::RandomDraw random = random_from(seed);
  Scene scene = folded_ladder(n, 1);
  scene.name = fmt::format("random_ladder_{:g}", seed);
  std::vector<double> base{0};  // where the rods stand [m]
  for (int k = 1; k <= n; ++k) base.push_back(base.back() + random.uniform(0.2, 2));
  for (int k = 0; k <= n; ++k) scene.bodies[k].position[0] += base[k] - k;
  for (int k = 1; k <= n; ++k) scene.bodies[n + k].position[0] += (base[k - 1] + base[k]) / 2 - (k - 0.5);
  for (scenes::Constraint& one : scene.constraints)
    for (auto* at : {&one.i, &one.j}) {
      double& x = (*at->point)[0];
      if (at->body == scenes::ground)
        x = base[std::lround(x)];
      else if (at->body > n)
        x *= base[at->body - n] - base[at->body - n - 1];
    }
  return scene;
}

/// lambda of a state by the linear-time solver in quad.
VectorX<double> lambda_in_quad(const Scene& scene) {
  const auto model = make_model<Quad>(scene);
  AccelerationSolver<ROmega<Quad>> solver(model.mechanism);
  solver.solve(to_coordinates<ROmega<Quad>>(model.mechanism, model.state, {}), model.state.t);
  return scalar_cast<double>(solver.lambda());
}

/// A large mechanism of n bodies, or about as many.
using MakeScene = std::function<Scene(int)>;

/// kappa of n bodies. The condition number of a straight chain grows with the square of its length. Where a
/// dense analysis of a hundred bodies finds a smaller one, it counts; from there on it grows as that of the
/// chain. `worse`: by how much the position is worse than a straight chain.
double kappa_of(const MakeScene& make, int n, double worse) {
  const double of_some = analyse_rows(make_model<double>(make(std::min(n, some)))).kappa,
               longer = std::max(1.0, static_cast<double>(n) / some);
  return std::min(of_some * longer * longer, worse * n * n);
}

/// lambda of the linear-time solver against the same solver in quad.
void judge_lambda(Judge& judge, const MakeScene& make, int n, double worse = 1) {
  const Scene scene = make(n);
  const VectorX<double> exact = lambda_in_quad(scene);
  const double kappa = kappa_of(make, n, worse);
  const SideBySide<double> answer =
      structured_side_by_side(make_model<double>(scene), SolveOptions{judge.formulations(), {}});
  for (const FormulationResult<double>& found : answer.formulations) {
    Row row = judge.row(found.name, "structured", "lambda [-]");
    promise(row, kappa);
    if (!found.error.empty()) {
      judge.add(judge.refused(row, found.error, scene));
      continue;
    }
    row.value = (found.solution.lambda - exact).lpNorm<Eigen::Infinity>() / exact.lpNorm<Eigen::Infinity>();
    judge.add(judge.judged(row, stated_error(found)));
  }
}

/// And a short motion, by methods that take steps of the same length at any size.
void judge_large(Judge& judge, const MakeScene& make, int n) {
  judge_lambda(judge, make, n);
  const Scene scene = make(n);
  HardMotion motion;
  motion.scene = scene;
  motion.end = 0.02;
  motion.step = 1e-4;  // bars of a large ring turn fast
  motion.methods = methods_of("size_and_place/large_mechanisms", judge.is_quick());
  motion.beside_simbody = scene.bodies.size() <= 200;  // more take minutes
  motion.starts = 2;                                   // of a thousand bodies each costs as much as a run
  judge.motion(motion);
}

Case generated(const char* name, Scene (*make)(int), int least) {
  return {name,
          "number of bodies",
          {static_cast<double>(least), 10000, true},
          static_cast<double>(least),
          {some},
          {many},
          [make](Judge& judge, double n) { judge_large(judge, make, static_cast<int>(n)); },
          [make](double n) { return make(static_cast<int>(n)); }};
}

/// Many bodies in a position that a number chooses.
Case placed(const char* name, const char* number, Scene (*make)(int, double), Accepted accepted, double easy,
            std::vector<double> quick, std::vector<double> whole) {
  return {name,
          number,
          accepted,
          easy,
          std::move(quick),
          std::move(whole),
          [make](Judge& judge, double x) {
            judge_lambda(
                judge, [&](int n) { return make(n, x); }, judge.is_quick() ? some : many);
          },
          [make](double x) { return make(many, x); }};
}

}  // namespace

std::vector<Case> large_mechanisms() {
  return {generated("chain", scenes::chain, 3),
          generated("ring", scenes::ring, 5),
          generated(
              "random_tree", [](int n) { return scenes::tree(n); }, 3),
          placed("zigzag", "inclination of each of a thousand bars (quick: a hundred) [rad]", zigzag,
                 {-1.5707, 1.5707}, 0.5, {0}, {0, 1, 1.5, 1.57}),
          placed("random_chain", "seed of the angles of a thousand bars (quick: a hundred)", random_chain,
                 {0, 1e9, true}, 1, {2}, {2, 3, 4}),
          placed("star_ring",
                 "share by which the corners of a ring of a thousand (quick: a hundred) are in and out",
                 star_ring, {0, 0.999}, 0.1, {0.9}, {0.5, 0.9, 0.99}),
          placed("random_ring", "seed of the corners of a ring of a thousand (quick: a hundred)", random_ring,
                 {0, 1e9, true}, 1, {2}, {2, 3, 4}),
          // its motion is a case of the singular positions
          {"ladder",
           "number of bodies",
           {2, 10000, true},
           3,
           {some},
           {many},
           [](Judge& judge, double n) {
             judge_lambda(
                 judge, [](int bodies) { return scenes::ladder(bodies / 2); }, static_cast<int>(n));
           },
           [](double n) { return scenes::ladder(static_cast<int>(n) / 2); }},
          {"folded_ladder",
           "angle of the rods of a ladder of 500 loops (quick: 50) [rad]",
           {1e-8, 1.5},
           1,
           {1e-3},
           {0.1, 1e-3, 1e-5},
           [](Judge& judge, double angle) {
             judge_lambda(
                 judge, [=](int n) { return folded_ladder(n / 2, angle); }, judge.is_quick() ? some : many,
                 1 / angle);
           },
           [](double angle) { return folded_ladder(many / 2, angle); }},
          {"random_ladder",
           "seed of the lengths of the couplers of 500 loops (quick: 50)",
           {0, 1e9, true},
           1,
           {2},
           {2, 3, 4},
           [](Judge& judge, double seed) {
             judge_lambda(
                 judge, [=](int n) { return random_ladder(n / 2, seed); }, judge.is_quick() ? some : many);
           },
           [](double seed) { return random_ladder(many / 2, seed); }}};
}

}  // namespace trivium::hard
