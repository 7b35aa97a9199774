/// Fuzz target. For any text the reader must either throw a SceneError, or return a finite and physical scene
/// that round-trips. The checks here use other formulas than the reader.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <set>
#include <string>

#include "base/raise.hpp"
#include "scenes/format/scene_file.hpp"

namespace trivium::scenes {
namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "accepted, although not: %s\n", what);
  std::abort();
}

void require_finite(std::initializer_list<double> numbers) {
  for (double x : numbers) require(std::abs(x) <= 1e100, "finite and at most 1e100");
}
void require_finite(const Vector3& v) { require_finite({v[0], v[1], v[2]}); }
void require_finite(const std::optional<Vector3>& v) {
  if (v) require_finite(*v);
}
void require_finite(const TimeFunction& f) {
  const Jet<double> jet = f(0.0);
  require(std::isfinite(jet.f) && std::isfinite(jet.f_t) && std::isfinite(jet.f_tt), "finite at t = 0");
}

Matrix3 full(const std::variant<Vector3, Matrix3>& inertia) {
  if (const Matrix3* J = std::get_if<Matrix3>(&inertia)) return *J;
  const Vector3& d = std::get<Vector3>(inertia);
  return {{{d[0], 0, 0}, {0, d[1], 0}, {0, 0, d[2]}}};
}

double determinant(const Matrix3& A) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
    sum += A[0][k] * (A[1][(k + 1) % 3] * A[2][(k + 2) % 3] - A[1][(k + 2) % 3] * A[2][(k + 1) % 3]);
  return sum;
}

/// Whether the principal minors of order 1 to 3 are >= 0 up to rounding, for a matrix with entries of size 1.
bool is_semidefinite(const Matrix3& J) {
  constexpr double tolerance = 1e-10;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    if (J[a][a] < -tolerance || J[a][a] * J[b][b] - J[a][b] * J[b][a] < -tolerance) return false;
  }
  return determinant(J) >= -tolerance;
}

/// A mass distribution has the second moment matrix (tr J / 2) I - J, which must be semidefinite, as must J.
void require_physical(const Body& body) {
  Matrix3 J = full(body.inertia);
  double size = 0;
  for (const Vector3& row : J)
    for (double x : row) raise(size, std::abs(x));
  if (size == 0) return;
  for (Vector3& row : J)
    for (double& x : row) x /= size;
  require(is_semidefinite(J), "a semidefinite inertia");
  if (body.unphysical_inertia) return;
  const double half_trace = (J[0][0] + J[1][1] + J[2][2]) / 2;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) J[a][b] = (a == b ? half_trace : 0) - J[a][b];
  require(is_semidefinite(J), "the inertia of a mass distribution");
}

void require_sound(const Orientation& orientation) {
  if (const auto* p = std::get_if<EulerParameters>(&orientation)) {
    require_finite({p->e[0], p->e[1], p->e[2], p->e[3]});
    const double square = p->e[0] * p->e[0] + p->e[1] * p->e[1] + p->e[2] * p->e[2] + p->e[3] * p->e[3];
    require(square > 0 && std::isfinite(1 / std::sqrt(square)), "Euler parameters with a norm");
  } else if (const auto* rotation = std::get_if<RotationMatrix>(&orientation)) {
    require(std::abs(determinant(rotation->A) - 1) < 1e-8, "a matrix with determinant 1");
  } else if (const auto* about = std::get_if<AxisAngle>(&orientation)) {
    require_finite(about->axis);
    require_finite({about->angle});
    require(about->axis != Vector3{}, "an axis with a direction");
  } else {
    require_finite(std::get<EulerAngles>(orientation).angles);
  }
}

bool is_body(int body, const Scene& scene) {
  return body >= 0 && static_cast<std::size_t>(body) < scene.bodies.size();
}

void require_sound(const Side& i, const Side& j, const Scene& scene) {
  for (const Side& side : {i, j}) {
    require(side.body == ground || is_body(side.body, scene), "a known body");
    for (const auto& v : {side.point, side.vector, side.axis, side.x}) require_finite(v);
    for (const auto& v : {side.vector, side.axis, side.x}) require(!v || *v != Vector3{}, "a direction");
  }
  require(i.body != j.body, "two bodies");
}

/// Key visitor that checks the values of an effect.
struct EffectLaws : ValueVisitor<EffectLaws> {
  const Scene& scene;
  const BodyPoint<double>* other = nullptr;

  explicit EffectLaws(const Scene& of) : scene(of) {}

  void body(std::string_view, int index) const { require(is_body(index, scene), "a load on a body"); }
  void point(std::string_view, const BodyPoint<double>& end) {
    require(end.body == ground || is_body(end.body, scene), "a known body");
    require(end.s_bar.allFinite(), "a finite point");
    require(other == nullptr || other->body != end.body, "two bodies");
    other = &end;
  }
  void joint(std::string_view, const JointAngle<double>& angle) const {
    require(properties_of(scene.constraints.at(static_cast<std::size_t>(angle.joint)).type).has_an_angle,
            "a joint with an angle");
  }
  void turns(std::string_view, const JointAngle<double>& angle) const { require_finite({angle.tracked}); }
  void value(std::string_view, double x) const { require_finite({x}); }
  void value(std::string_view, ComponentFrame) const {}
  void value(std::string_view, const trivium::Vector3<double>& v) const {
    require(v.allFinite(), "a finite vector");
  }
  void value(std::string_view, const TimeFunction& f) const { require_finite(f); }
  void value(std::string_view, const std::array<TimeFunction, 3>& functions) const {
    for (const TimeFunction& f : functions) require_finite(f);
  }
};

void require_sound(const Scene& scene) {
  std::set<std::string> bodies{"", "ground"}, constraints{""};
  require(!scene.bodies.empty(), "a body");
  for (const Body& body : scene.bodies) {
    require(bodies.insert(body.name).second, "a new name");
    require_finite({body.mass});
    require(body.mass > 0, "a positive mass");
    require_physical(body);
    require_sound(body.orientation);
    for (const Vector3& v : {body.position, body.velocity, body.angular_velocity}) require_finite(v);
  }
  for (const Constraint& constraint : scene.constraints) {
    require(constraints.insert(constraint.name).second, "a new name");
    require_sound(constraint.i, constraint.j, scene);
    require_finite(constraint.f);
    require_finite(constraint.angle);
    require_finite(constraint.direction);
    require_finite({constraint.distance});
  }
  for (const Effect& effect : scene.effects) visit_keys(EffectLaws(scene), effect);
}

void require_readable(const std::string& message) {
  require(message.starts_with("fuzz: "), "a message that names the file");
  require(message.size() < 4000, "a short message");
  for (unsigned char c : message) require(c >= 0x20 && c != 0x7f, "a message without control characters");
}

}  // namespace
}  // namespace trivium::scenes

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trivium::scenes;
  Scene scene;
  try {
    scene = parse_scene({reinterpret_cast<const char*>(data), size}, "fuzz");
  } catch (const SceneError& error) {
    require_readable(error.what());
    return 0;
  }
  require_sound(scene);
  const std::string text = write_scene(scene);
  const Scene again = parse_scene(text, "written");
  require(again == scene, "the same scene again");
  require(write_scene(again) == text, "the same text again");
  return 0;
}
