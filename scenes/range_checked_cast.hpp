#pragma once
/// Casts the numbers of a scene, which are doubles, to a Scalar whose range may be smaller. This file decides
/// which numbers are refused (too large for Scalar, or too small where the magnitude matters) and which
/// numbers are rounded to zero (positions, velocities, angles, single components).

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "bodies/numbers/time_function.hpp"
#include "bodies/numbers/vectors.hpp"
#include "scenes/scene.hpp"

namespace trivium {

/// Casts the numbers of one part of a scene to Scalar. A number that overflows throws a ModelError that names
/// the part, the key and the number. A number that underflows (to 0 or to a subnormal number of Scalar, which
/// has fewer digits) also throws, but only where its magnitude matters; elsewhere it is rounded. If Scalar
/// holds every double, the checks are compiled away.
template <class Scalar>
class RangeCheckedCast {
 public:
  static constexpr bool holds_every_double =
      std::numeric_limits<Scalar>::max_exponent >= std::numeric_limits<double>::max_exponent;

  /// The kind and the name of the part for messages, such as body and "crank". Both texts must outlive this
  /// object.
  RangeCheckedCast(std::string_view kind, std::string_view name) : kind_(kind), name_(name) {}

  /// A number whose magnitude matters, such as a mass: neither overflow nor underflow is accepted.
  Scalar number(double x, std::string_view key) const {
    if constexpr (!holds_every_double)
      if (overflows(x) || vanishes(x)) fail(x, key);
    return Scalar(x);
  }
  /// An angle [rad] may underflow: the error is less than the rounding error of the rotation.
  Scalar angle(double x, std::string_view key) const {
    if constexpr (!holds_every_double)
      if (overflows(x)) fail(x, key);
    return Scalar(x);
  }
  /// Three doubles of a position or a velocity. A component may underflow. This error, at most 1e-38 in
  /// float, has no effect on the motion.
  template <class Three>
  Vector3<Scalar> place(const Three& v, std::string_view key) const {
    if constexpr (!holds_every_double)
      for (double x : v)
        if (overflows(x)) fail(x, key);
    return {Scalar(v[0]), Scalar(v[1]), Scalar(v[2])};
  }
  /// Three doubles whose common magnitude matters. A component may underflow as long as another component
  /// remains. If all nonzero components underflow, the vector would lose its digits and is refused.
  template <class Three>
  Vector3<Scalar> vector(const Three& v, std::string_view key) const {
    if constexpr (!holds_every_double) {
      bool any_left = false;
      for (double x : v) any_left = any_left || (x != 0 && !vanishes(x));
      for (double x : v)
        if (overflows(x) || (vanishes(x) && !any_left)) fail(x, key);
    }
    return {Scalar(v[0]), Scalar(v[1]), Scalar(v[2])};
  }
  Vector3<Scalar> vector(const std::optional<scenes::Vector3>& v, std::string_view key) const {
    return v ? vector(*v, key) : Vector3<Scalar>(Vector3<Scalar>::Zero());
  }
  /// A function of time keeps its doubles and is evaluated in Scalar. All its numbers must therefore fit into
  /// Scalar.
  const TimeFunction& function(const TimeFunction& f, std::string_view key) const {
    if constexpr (!holds_every_double) std::visit([&](const auto& kind) { check(kind, key); }, f.kind());
    return f;
  }
  const std::array<TimeFunction, 3>& functions(const std::array<TimeFunction, 3>& f,
                                               std::string_view key) const {
    for (const TimeFunction& component : f) function(component, key);
    return f;
  }

  /// A time that is a Scalar already. Throws ModelError if it is not finite.
  static const Scalar& time(const Scalar& t) {
    if constexpr (!holds_every_double)
      if (!std::isfinite(t))
        throw ModelError(
            fmt::format("the time t is beyond the range of {}; use --scalar double", scalar_name()));
    return t;
  }

 private:
  static bool overflows(double x) { return !std::isfinite(static_cast<Scalar>(x)); }
  /// Whether x is not zero as a double, but zero or subnormal as a Scalar.
  static bool vanishes(double x) {
    return x != 0 && std::abs(static_cast<Scalar>(x)) < std::numeric_limits<Scalar>::min();
  }
  static constexpr std::string_view scalar_name() {
    return std::is_same_v<Scalar, float> ? "float" : "this scalar";
  }
  [[noreturn]] void fail(double x, std::string_view key) const {
    throw ModelError(fmt::format("{} \"{}\": {} {} is beyond the range of {}; use --scalar double", kind_,
                                 name_, key, x, scalar_name()));
  }

  void check(double constant, std::string_view key) const { number(constant, key); }
  void check(const TimeFunction::Polynomial& f, std::string_view key) const {
    for (double c : f.coefficients) number(c, key);
  }
  void check(const TimeFunction::Harmonic& f, std::string_view key) const {
    for (double x : {f.offset, f.amplitude, f.angular_frequency}) number(x, key);
    angle(f.phase, key);
  }
  void check(const TimeFunction::Sin& f, std::string_view key) const { check(f.of, key); }
  void check(const TimeFunction::Cos& f, std::string_view key) const { check(f.of, key); }
  void check(const TimeFunction::Sum& f, std::string_view key) const { check(f.terms, key); }
  void check(const TimeFunction::Product& f, std::string_view key) const { check(f.factors, key); }
  void check(const TimeFunction::Step5& f, std::string_view key) const {
    for (double x : {f.t0, f.f0, f.t1, f.f1}) number(x, key);
  }
  void check(const TimeFunction::Piecewise& f, std::string_view key) const {
    for (double t : f.times) number(t, key);
    check(f.pieces, key);
  }
  void check(const std::vector<TimeFunction>& parts, std::string_view key) const {
    for (const TimeFunction& part : parts) function(part, key);
  }

  std::string_view kind_, name_;
};

}  // namespace trivium
