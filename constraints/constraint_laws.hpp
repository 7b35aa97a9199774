#pragma once
/// The laws of a basic constraint, a test for new constraints. The concept DotProductConstraint checks which
/// members exist. `broken_laws` checks at one state of two moving bodies that the members are consistent: nu
/// and gamma with the difference quotients of Phi and Phi', and `keys`, `is_of_angle`,
/// `sees_relative_motion`, `function` and `vanishes` with the row. Of `scale` only the sign is checked, not
/// the value.

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "base/broken_law.hpp"
#include "bodies/rotations/so3.hpp"
#include "constraints/constraint_keys.hpp"
#include "constraints/constraint_row.hpp"
#include "constraints/plain_body.hpp"

namespace trivium {

namespace detail {

/// Evaluates the laws of a constraint at one state and lists those that do not hold.
template <class C, class S>
class ConstraintLaws {
 public:
  ConstraintLaws(const C& constraint, const PlainBody<S>& i, const PlainBody<S>& j, const S& t)
      : c_(constraint), i_(i), j_(j), t_(t) {}

  std::vector<BrokenLaw> broken() {
    using std::cbrt;
    const S u = std::numeric_limits<S>::epsilon(), h(cbrt(u));
    const auto row = evaluate_row(c_, i_, j_, t_);
    const S along =
        row.r_i.dot(i_.r_dot) + row.rot_i.dot(i_.omega) + row.r_j.dot(j_.r_dot) + row.rot_j.dot(j_.omega);
    const S scale = c_.scale(t_);
    size_ = scale + row.r_i.norm() * i_.r_dot.norm() + row.r_j.norm() * j_.r_dot.norm() +
            row.rot_i.norm() * i_.omega.norm() + row.rot_j.norm() * j_.omega.norm();
    require("scale is not negative", scale >= S(0));
    if (C::is_of_angle)
      require("a row of an angle does not depend on positions r", (row.r_i - row.r_j).norm() == S(0));
    const S of_places = row.r_i.norm() + row.r_j.norm(), of_turns = row.rot_i.norm() + row.rot_j.norm();
    if (!C::is_of_angle)
      require("a row of a length depends on positions r", of_places > S(0) || of_turns == S(0));
    // 1e-3: the gradient is far from zero. 1e-9: smaller than any threshold that a solver passes to vanishes
    if constexpr (requires { c_.vanishes(i_, j_, scale); })
      require("vanishes is false if the gradient of the row is not zero",
              !(of_places + of_turns > S(1e-3) * scale && c_.vanishes(i_, j_, S(1e-9))));
    bool has_function = false, is_function = false;
    show_constraint_parts(
        [&](const auto& part) {
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(part)>, TimeFunction>) {
            has_function = true;
            is_function = is_function || part == c_.function();
          }
        },
        c_);
    require("the function of time of a row is one of its parts", is_function || !has_function);
    if constexpr (requires { C::sees_relative_motion; })
      if (C::sees_relative_motion) {
        const Vector3<S> turn(S(0.3), S(-0.7), S(0.4)), shift(S(-0.2), S(0.5), S(0.9));
        const Matrix3<S> A = rotation_matrix(exponential_parameters<S>(turn));
        const auto carried = [&](PlainBody<S> body) {
          body.r = A * body.r + shift;
          body.A = (A * body.A).eval();
          return body;
        };
        // 1e4, here and below, is a safety factor on the rounding error: far above the few roundings of a row
        // that is right, far below the relative error of about 1 of a row that is wrong
        equal("a common rigid motion of both bodies does not change Phi",
              row_position(c_, carried(i_), carried(j_), t_), row.phi, 1e4 * static_cast<double>(u));
      }
    // central differences: both bodies are moved by +-h along their r' and omega. The truncation error is of
    // order h^2, the rounding error of order epsilon / h, where epsilon is the local `u`. With h =
    // cbrt(epsilon) both are of order h^2.
    const double coarse = 1e4 * static_cast<double>(h) * static_cast<double>(h);
    equal("Phi_q q' - nu is the time derivative of Phi", along - row.nu, S((phi(h) - phi(-h)) / (2 * h)),
          coarse);
    equal("-gamma is the time derivative of Phi' without accelerations", -row.gamma,
          S((phi_dot(h) - phi_dot(-h)) / (2 * h)), coarse);
    static thread_local C copy;  // static, so that parts which keys omit are zero and not uninitialised
    show_constraint_parts([](const auto& from, auto& to) { to = from; }, c_, copy);
    equal("show_constraint_parts shows every part", evaluate_row(copy, i_, j_, t_).phi, row.phi, 0);
    equal("show_constraint_parts shows every part", copy.scale(t_), scale, 0);
    return broken_;
  }

 private:
  static PlainBody<S> moved(PlainBody<S> body, const S& by) {
    body.r += by * body.r_dot;
    body.A = (rotation_matrix(exponential_parameters<S>(by * body.omega)) * body.A).eval();
    return body;
  }
  S phi(const S& by) const { return row_position(c_, moved(i_, by), moved(j_, by), S(t_ + by)); }
  S phi_dot(const S& by) const { return row_velocity(c_, moved(i_, by), moved(j_, by), S(t_ + by)); }

  void require(const char* law, bool holds) {
    if (!holds) broken_.push_back({law, 1, 0});
  }
  void equal(const char* law, const S& a, const S& b, double bound) {
    using std::abs;
    const S apart = abs(S(a - b)), size = size_ + abs(a) + abs(b);
    const double off = static_cast<double>(size > S(0) ? S(apart / size) : apart);
    if (!(off <= bound)) broken_.push_back({law, off, bound});
  }

  const C& c_;
  const PlainBody<S>&i_, &j_;
  const S& t_;
  S size_{1};
  std::vector<BrokenLaw> broken_;
};

}  // namespace detail

/// The laws that `constraint` breaks with bodies i and j in this motion at time t [s]; empty if none. The
/// state should be generic, without distances of zero.
template <class C, class S>
std::vector<BrokenLaw> broken_laws(const C& constraint, const PlainBody<S>& i, const PlainBody<S>& j,
                                   const S& t) {
  static_assert(DotProductConstraint<C, S>);
  return detail::ConstraintLaws<C, S>(constraint, i, j, t).broken();
}

}  // namespace trivium
