#include "scenes/testing/arbitrary_scene.hpp"

#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>
#include <variant>

#include "base/variants.hpp"
#include "scenes/format/scene_keys.hpp"

namespace trivium::scenes {
namespace {

/// Random numbers from rapidcheck's generators, so that rapidcheck can shrink a failing scene.
class Random {
 public:
  int below(int n) { return *rc::gen::inRange(0, n); }
  bool flip() { return below(2) == 1; }
  double uniform() {
    constexpr std::int64_t one = std::int64_t{1} << 53;
    return static_cast<double>(*rc::gen::inRange<std::int64_t>(-one, one + 1)) / static_cast<double>(one);
  }
  /// Signed zeros, integers, decimals with two digits, and numbers of every magnitude from 1e-20 to 1e20.
  double number() {
    switch (below(5)) {
      case 0:
        return flip() ? 0.0 : -0.0;
      case 1:
        return below(2001) - 1000;
      case 2:
        return (below(2001) - 1000) / 100.0;
      case 3:
        return uniform() * std::pow(10, below(41) - 20);
      default:
        return uniform();
    }
  }
  double positive() { return std::abs(number()) + 1e-3; }
  Vector3 vector() { return {number(), number(), number()}; }
  Vector3 direction() { return {number(), uniform() + 2, number()}; }
  std::optional<Vector3> perhaps_vector() { return flip() ? std::optional(vector()) : std::nullopt; }
};

Matrix3 arbitrary_rotation(Random& random) {
  const double angle = random.uniform() * 4, c = std::cos(angle), s = std::sin(angle);
  switch (random.below(3)) {
    case 0:
      return {{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
    case 1:
      return {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
    default:
      return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
  }
}

Orientation arbitrary_orientation(Random& random) {
  switch (random.below(4)) {
    case 0:
      return EulerParameters{{random.number(), random.number(), random.number(), random.positive()}};
    case 1: {
      const auto name = euler_sequence_names[static_cast<std::size_t>(random.below(12))];
      return EulerAngles{random.vector(), *parse_euler_sequence(name)};
    }
    case 2:
      return AxisAngle{random.direction(), random.number()};
    default:
      return RotationMatrix{arbitrary_rotation(random)};
  }
}

Body arbitrary_body(Random& random, int index) {
  Body body;
  body.name = fmt::format("body {}", index) + (random.flip() ? " \"ä/~\\\n" : "");
  body.mass = random.positive();
  const double x = random.positive(), y = random.positive(), z = random.positive();  // second moments
  if (random.flip()) {
    body.inertia = Vector3{y + z, z + x, x + y};
  } else {  // diagonally dominant, and the moments obey the triangle inequality
    const double off = 0.1 * random.uniform() * x;
    body.inertia = Matrix3{{{2 * x, off, 0}, {off, 2 * x, off}, {0, off, 2 * x}}};
  }
  if (random.below(4) == 0) {
    body.unphysical_inertia = true;
    body.inertia = Vector3{x, y, 0};
  }
  body.position = random.vector();
  body.orientation = arbitrary_orientation(random);
  if (random.flip()) body.velocity = random.vector(), body.angular_velocity = random.vector();
  return body;
}

TimeFunction arbitrary_function(Random& random, int depth = 0) {
  const auto parts = [&] {
    std::vector<TimeFunction> functions;
    for (int k = random.below(3); k >= 0; --k) functions.push_back(arbitrary_function(random, depth + 1));
    return functions;
  };
  switch (random.below(depth < 3 ? 9 : 4)) {
    case 0:
      return random.number();
    case 1:
      return TimeFunction::Polynomial{{random.number(), random.number(), random.number()}};
    case 2:
      return TimeFunction::Harmonic{random.number(), random.number(), random.uniform(), random.number()};
    case 3: {
      const double t0 = random.uniform();
      return TimeFunction::Step5{t0, random.number(), t0 + random.positive(), random.number()};
    }
    case 4:
      return TimeFunction::Sin{{arbitrary_function(random, 3)}};
    case 5:
      return TimeFunction::Cos{{arbitrary_function(random, 3)}};
    case 6:
      return TimeFunction::Sum{parts()};
    case 7: {  // both pieces are the same function, since a driver must not jump
      const TimeFunction f = arbitrary_function(random, depth + 1);
      return TimeFunction::Piecewise{{random.number()}, {f, f}};
    }
    default:
      return TimeFunction::Product{{arbitrary_function(random, 3), arbitrary_function(random, 3)}};
  }
}

Side arbitrary_side(Random& random, int body, const Shape& shape) {
  Side side;
  side.body = body;
  if (shape.find("point")) side.point = random.perhaps_vector();
  if (shape.find("vector")) side.vector = random.direction();
  const double s = random.positive();
  const auto wanted = [&](const char* key) {
    return shape.find(key) && (shape.find(key)->required || random.flip());
  };
  if (wanted("axis")) side.axis = Vector3{0, s, random.uniform()};
  if (side.axis && wanted("x")) side.x = Vector3{s, random.uniform(), 0};
  return side;
}

Constraint arbitrary_constraint(Random& random, int index, int bodies) {
  const ConstraintShape& shape = constraint_shapes()[static_cast<std::size_t>(
      random.below(static_cast<int>(constraint_shapes().size())))];
  Constraint constraint;
  constraint.type = shape.type;
  constraint.name = fmt::format("c{}", index);
  const int i = random.below(bodies + 1) - 1;
  const int j = i == ground || random.flip() ? random.below(bodies) : ground;
  constraint.i = arbitrary_side(random, i, *shape.i);
  constraint.j = arbitrary_side(random, j == i ? ground : j, *shape.j);
  if (shape.shape.find("f")) constraint.f = arbitrary_function(random);
  if (shape.needs_positive_f) constraint.f = random.positive();
  if (shape.shape.find("direction")) constraint.direction = random.direction();
  if (shape.shape.find("distance")) constraint.distance = random.positive();
  if (shape.shape.find("angle")) constraint.angle = arbitrary_function(random);
  return constraint;
}

/// Key visitor that draws the values of an effect.
struct ArbitraryEffect : ValueVisitor<ArbitraryEffect> {
  Random& random;
  const Scene& scene;
  bool is_first = true;  ///< the next point is the first of two

  ArbitraryEffect(Random& from, const Scene& of) : random(from), scene(of) {}

  void body(std::string_view, int& index) { index = random.below(static_cast<int>(scene.bodies.size())); }
  void point(std::string_view key, BodyPoint<double>& end) {
    int index = 0;
    body(key, index);
    end.body = std::exchange(is_first, false) ? index : ground;
    if (random.flip()) value(key, end.s_bar);
  }
  void joint(std::string_view, JointAngle<double>& angle) {
    for (std::size_t k = 0; k < scene.constraints.size(); ++k)
      if (properties_of(scene.constraints[k].type).has_an_angle) angle.joint = static_cast<int>(k);
  }
  void turns(std::string_view, JointAngle<double>& angle) { angle.set_turns(random.below(7) - 3); }
  void value(std::string_view, double& number) { number = random.number(); }
  void value(std::string_view, trivium::Vector3<double>& v) {
    v = trivium::Vector3<double>(random.vector().data());
  }
  void value(std::string_view, ComponentFrame& frame) {
    frame = random.flip() ? ComponentFrame::global : ComponentFrame::body;
  }
  void value(std::string_view, TimeFunction& f) { f = arbitrary_function(random); }
  void value(std::string_view, std::array<TimeFunction, 3>& f) {
    f = {arbitrary_function(random), random.number(), random.number()};
  }
};

/// Key visitor that finds out whether an effect needs a joint with an angle.
struct NeedsAJoint : KeyVisitor {
  bool& found;
  explicit NeedsAJoint(bool& out) : found(out) {}
  void joint(std::string_view, auto&) const { found = true; }
};

Effect arbitrary_effect(Random& random, int index, const Scene& scene) {
  const bool has_angle = std::any_of(scene.constraints.begin(), scene.constraints.end(),
                                     [](const Constraint& c) { return properties_of(c.type).has_an_angle; });
  Effect effect = emplaced<Effect>(random.below(static_cast<int>(std::variant_size_v<Effect>)));
  bool needs_a_joint = false;
  visit_keys(NeedsAJoint(needs_a_joint), effect);
  if (needs_a_joint && !has_angle) effect = Gravity<double>{};
  if (random.flip()) std::visit([&](auto& one) { one.name = fmt::format("e{}", index); }, effect);
  visit_keys(ArbitraryEffect(random, scene), effect);
  return effect;
}

}  // namespace

Scene arbitrary_scene() {
  Random random;
  Scene scene;
  if (random.flip()) scene.name = "random", scene.description = "drawn by \"rapidcheck\"";
  const int bodies = 1 + random.below(12);
  for (int k = 0; k < bodies; ++k) scene.bodies.push_back(arbitrary_body(random, k));
  for (int k = random.below(13); k > 0; --k)
    scene.constraints.push_back(arbitrary_constraint(random, k, bodies));
  for (int k = random.below(13); k > 0; --k) scene.effects.push_back(arbitrary_effect(random, k, scene));
  if (random.flip()) {
    SavedRun& saved = scene.saved.emplace();
    saved.t = random.number();
    saved.start = random.number();
    saved.formulation = "r-epsilon";
    saved.integrator = "radau5";
    saved.phi = random.positive();
    saved.phi_dot = random.positive();
    saved.began_singular = random.flip();
    for (int k = random.below(3); k > 0; --k) saved.fastest.push_back(random.positive());
    for (int k = random.below(3); k > 0; --k) saved.memory.push_back(random.number());
    if (random.flip()) saved.charts.assign(scene.bodies.size(), "313 Rx(90)");
    for (int k = random.below(30); k > 0; --k) saved.y.push_back(random.number());
    for (int k = random.below(3); k > 0; --k) saved.angles.push_back(random.number());
  }
  return scene;
}

}  // namespace trivium::scenes
