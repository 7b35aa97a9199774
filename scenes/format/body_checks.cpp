/// Checks of bodies: mass, inertia and orientation (declared in scene_checks.hpp).

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "bodies/inertia.hpp"
#include "scenes/format/scene_checks.hpp"

namespace trivium::scenes {
namespace {

std::string numbers(const Vector3& v) { return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v[0], v[1], v[2]); }

/// The principal moments in ascending order. The upper triangle of J is used for both triangles.
Vector3 principal_moments(const Matrix3& J) {
  Eigen::Matrix3d upper = Eigen::Matrix3d::Zero();
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) upper(a, b) = upper(b, a) = J[a][b];
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(upper, Eigen::EigenvaluesOnly).eigenvalues();
  return {moments[0], moments[1], moments[2]};
}

void check_symmetry(const Matrix3& J, double tolerance, const Path& at) {
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = a + 1; b < 3; ++b)
      if (!(std::abs(J[a][b] - J[b][a]) <= tolerance))
        fail(at,
             fmt::format("entries {}{} and {}{} are {} and {}", a + 1, b + 1, b + 1, a + 1, shortest(J[a][b]),
                         shortest(J[b][a])),
             "a symmetric matrix");
}

void check_inertia(const Body& body, const Path& at) {
  const auto tolerance_of = [](double trace) { return inertia_tolerance * std::max(trace, 0.0); };
  Vector3 moments;
  double tolerance = 0;
  if (const Matrix3* J = std::get_if<Matrix3>(&body.inertia)) {
    tolerance = tolerance_of((*J)[0][0] + (*J)[1][1] + (*J)[2][2]);
    check_symmetry(*J, tolerance, at);
    moments = principal_moments(*J);
    if (!(moments[0] >= -tolerance))
      fail(at, fmt::format("principal moments {}", numbers(moments)), "a positive semidefinite matrix");
  } else {
    moments = std::get<Vector3>(body.inertia);
    tolerance = tolerance_of(moments[0] + moments[1] + moments[2]);
    if (!(*std::min_element(moments.begin(), moments.end()) >= -tolerance))
      fail(at, "moments " + numbers(moments), "moments >= 0");
    std::sort(moments.begin(), moments.end());
  }
  if (!body.unphysical_inertia && !(moments[2] <= moments[0] + moments[1] + tolerance))
    fail(at,
         fmt::format("principal moments {}, of which one exceeds the sum of the others", numbers(moments)),
         "moments that obey the triangle inequality, as those of every mass distribution do; "
         "\"unphysical_inertia\": true switches this check off");
}

class OrientationChecks {
 public:
  explicit OrientationChecks(const Path& at) : at_(at) {}

  void operator()(const EulerParameters& p) const {
    const double length = std::hypot(std::hypot(p.e[0], p.e[1]), std::hypot(p.e[2], p.e[3]));
    if (!(length >= smallest_divisor))
      fail(at_ / "euler_parameters", "norm " + shortest(length),
           "four numbers that can be normalised: norm >= " + shortest(smallest_divisor));
  }
  void operator()(const EulerAngles& angles) const {
    if (!parse_euler_sequence(angles.sequence.name()))
      fail(at_ / "sequence", "unknown sequence " + in_quotes(angles.sequence.name()),
           list_of({euler_sequence_names.begin(), euler_sequence_names.end()}));
  }
  void operator()(const AxisAngle& rotation) const {
    const Path at = at_ / "axis_angle";
    check_direction(rotation.axis, at / "axis");
  }
  void operator()(const RotationMatrix& rotation) const {
    const auto& A = rotation.A;
    const std::string accepted =
        fmt::format("a rotation: A A^T = I within {}, det A = 1", shortest(rotation_tolerance));
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = a; b < 3; ++b) {
        const double dot = A[a][0] * A[b][0] + A[a][1] * A[b][1] + A[a][2] * A[b][2];
        if (!(std::abs(dot - (a == b ? 1 : 0)) <= rotation_tolerance))
          fail(at_ / "matrix",
               fmt::format("rows {} and {} have the dot product {}", a + 1, b + 1, shortest(dot)), accepted);
      }
    const double det = A[0][0] * (A[1][1] * A[2][2] - A[1][2] * A[2][1]) -
                       A[0][1] * (A[1][0] * A[2][2] - A[1][2] * A[2][0]) +
                       A[0][2] * (A[1][0] * A[2][1] - A[1][1] * A[2][0]);
    if (!(det > 0)) fail(at_ / "matrix", "a reflection: det A = -1", accepted);
  }

 private:
  const Path& at_;
};

}  // namespace

void check_body(const Body& body, const Path& at) {
  if (!(body.mass >= smallest_divisor))
    fail(at / "mass", "found " + shortest(body.mass),
         fmt::format("a mass > 0 (at least {})", shortest(smallest_divisor)));
  check_inertia(body, at / "inertia");
  const Path orientation = at / "orientation";
  std::visit(OrientationChecks(orientation), body.orientation);
}

}  // namespace trivium::scenes
