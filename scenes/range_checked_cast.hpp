#pragma once
/// The numbers of a scene, which are doubles, in a Scalar that may hold less. Decided here: which numbers are
/// refused (too large for Scalar, or too small where their size counts) and which are rounded to zero
/// (places, angles, single components).

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

/// Takes the numbers of one thing of a scene to Scalar. One beyond its range, which would become infinite or
/// lose its digits near zero, is a ModelError that names the thing, the key and the number. Costs nothing
/// where Scalar holds every double.
template <class Scalar>
class RangeCheckedCast {
 public:
  static constexpr bool holds_every_double =
      std::numeric_limits<Scalar>::max_exponent >= std::numeric_limits<double>::max_exponent;

  /// As in: body "crank". Both outlive this.
  RangeCheckedCast(std::string_view kind, std::string_view name) : kind_(kind), name_(name) {}

  Scalar number(double x, std::string_view key) const {
    if constexpr (!holds_every_double)
      if (overflows(x) || vanishes(x)) fail(x, key);
    return Scalar(x);
  }
  /// Whatever is lost of an angle near zero is less than a rounding of the turn.
  Scalar angle(double x, std::string_view key) const {
    if constexpr (!holds_every_double)
      if (overflows(x)) fail(x, key);
    return Scalar(x);
  }
  /// Of three numbers in doubles. A position or a velocity near zero is rounded to it like any other.
  template <class Three>
  Vector3<Scalar> place(const Three& v, std::string_view key) const {
    if constexpr (!holds_every_double)
      for (double x : v)
        if (overflows(x)) fail(x, key);
    return {Scalar(v[0]), Scalar(v[1]), Scalar(v[2])};
  }
  /// A component that vanishes beside others that do not is rounded like any digit; a vector that vanishes is
  /// lost.
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
  /// A function of time keeps its doubles and is evaluated in Scalar: all of its numbers must go there.
  const TimeFunction& function(const TimeFunction& f, std::string_view key) const {
    if constexpr (!holds_every_double) std::visit([&](const auto& kind) { check(kind, key); }, f.kind());
    return f;
  }
  const std::array<TimeFunction, 3>& functions(const std::array<TimeFunction, 3>& f,
                                               std::string_view key) const {
    for (const TimeFunction& component : f) function(component, key);
    return f;
  }

  /// A time that has been cast already.
  static const Scalar& time(const Scalar& t) {
    if constexpr (!holds_every_double)
      if (!std::isfinite(t))
        throw ModelError(
            fmt::format("the time t is beyond the range of {}; use --scalar double", scalar_name()));
    return t;
  }

 private:
  static bool overflows(double x) { return !std::isfinite(static_cast<Scalar>(x)); }
  /// Zero or subnormal, and not so in the scene.
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
