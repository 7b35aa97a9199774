/// Checks of functions of time: parts, nesting, finite values and jumps (declared in scene_checks.hpp).

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "scenes/format/scene_checks.hpp"

namespace trivium::scenes {
namespace {

/// Checks that a function has all its parts and is not nested deeper than its file may be.
class PartChecks {
 public:
  explicit PartChecks(const Path& at) : at_(at) {}

  void operator()(double) const {}
  void operator()(const TimeFunction::Polynomial& f) const {
    check_count(f.coefficients.size(), "coefficients", "at least one coefficient");
  }
  void operator()(const TimeFunction::Harmonic&) const { check_depth(at_); }
  void operator()(const TimeFunction::Sin& f) const { check_argument(f.of); }
  void operator()(const TimeFunction::Cos& f) const { check_argument(f.of); }
  void operator()(const TimeFunction::Sum& f) const {
    check_count(f.terms.size(), "terms", "at least one term");
    check_parts(f.terms, at_ / "terms");
  }
  void operator()(const TimeFunction::Product& f) const {
    check_count(f.factors.size(), "factors", "at least one factor");
    check_parts(f.factors, at_ / "factors");
  }
  void operator()(const TimeFunction::Step5& f) const {
    check_depth(at_);
    if (!(f.t1 - f.t0 >= smallest_divisor))
      fail(at_ / "t1", fmt::format("t1 = {} with t0 = {}", shortest(f.t1), shortest(f.t0)), "t1 > t0");
  }
  void operator()(const TimeFunction::Piecewise& f) const {
    check_count(f.times.size(), "times", "at least one time");
    const Path pieces = at_ / "pieces";
    check_depth(pieces);
    if (f.pieces.size() != f.times.size() + 1)
      fail(pieces, fmt::format("{} pieces for {} times", f.pieces.size(), f.times.size()),
           "one more piece than times");
    const Path times = at_ / "times";
    for (std::size_t k = 1; k < f.times.size(); ++k)
      if (!(f.times[k] - f.times[k - 1] >= smallest_divisor))
        fail(times / k, fmt::format("{} after {}", shortest(f.times[k]), shortest(f.times[k - 1])),
             "times in ascending order");
    check_parts(f.pieces, pieces);
  }

 private:
  /// A path of length n leads to a value at nesting level n, so a container at this place has level n + 1.
  static void check_depth(const Path& at) {
    if (at.depth() >= deepest_nesting)
      fail(at, "nested too deep", fmt::format("at most {} levels of objects and arrays", deepest_nesting));
  }
  void check_count(std::size_t count, std::string_view key, std::string accepted) const {
    check_depth(at_ / key);
    if (count == 0) fail(at_ / key, "an empty array", std::move(accepted));
  }
  void check_argument(const std::vector<TimeFunction>& of) const {
    check_depth(at_);
    const Path at = at_ / "of";
    if (of.size() != 1) fail(at, fmt::format("{} functions", of.size()), "one function");
    std::visit(PartChecks(at), of.front().kind());
  }
  static void check_parts(const std::vector<TimeFunction>& parts, const Path& at) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Path part = at / k;
      std::visit(PartChecks(part), parts[k].kind());
    }
  }

  const Path& at_;
};

void check_finite(const TimeFunction& f, double t, const Path& at) {
  const Jet<double> jet = f(t);
  if (!std::isfinite(jet.f) || !std::isfinite(jet.f_t) || !std::isfinite(jet.f_tt))
    fail(at, fmt::format("f, f', f'' = {}, {}, {} at t = {}", jet.f, jet.f_t, jet.f_tt, shortest(t)),
         "a function whose value and derivatives are finite");
}

/// Checks a function of a constraint for jumps: positions cannot jump, velocities may.
void check_continuous(const TimeFunction& f, const Path& at) {
  std::vector<double> times;
  f.append_kinks(times);
  for (const double t : times) {
    const double before = f(std::nextafter(t, -std::numeric_limits<double>::infinity())).f, after = f(t).f;
    constexpr double jump_tolerance = 1e-9;  // larger than the rounding of numbers that a file states
    if (!(std::abs(after - before) <= jump_tolerance * (1 + std::abs(before))))
      fail(at, fmt::format("a jump from {} to {} at t = {}", shortest(before), shortest(after), shortest(t)),
           "a function without jumps, because positions cannot jump; the derivative may jump");
  }
}

/// Key visitor that checks the functions of time of an effect.
struct FunctionsOfEffect : ValueVisitor<FunctionsOfEffect> {
  double t;
  const Path& at;

  FunctionsOfEffect(double time, const Path& place) : t(time), at(place) {}

  void body(std::string_view, auto&) const {}
  void point(std::string_view, auto&) const {}
  void joint(std::string_view, auto&) const {}
  void value(std::string_view, const auto&) const {}
  void value(std::string_view key, const TimeFunction& f) const { check_finite(f, t, at / key); }
  void value(std::string_view key, const std::array<TimeFunction, 3>& functions) const {
    const Path place = at / key;
    for (std::size_t k = 0; k < functions.size(); ++k) check_finite(functions[k], t, place / k);
  }
};

}  // namespace

void check_function(const TimeFunction& f, const Path& at) {
  std::visit(PartChecks(at), f.kind());
  check_finite(f, 0, at);
}

void check_functions(const Scene& scene, double t, const Path& root) {
  const Path constraints = root / "constraints", effects = root / "effects";
  for (std::size_t k = 0; k < scene.constraints.size(); ++k) {
    const Path at = constraints / k;
    check_finite(scene.constraints[k].f, t, at / "f");
    check_finite(scene.constraints[k].angle, t, at / "angle");
    check_continuous(scene.constraints[k].f, at / "f");
    check_continuous(scene.constraints[k].angle, at / "angle");
  }
  for (std::size_t k = 0; k < scene.effects.size(); ++k) {
    const Path at = effects / k;
    visit_keys(FunctionsOfEffect(t, at), scene.effects[k]);
  }
}

}  // namespace trivium::scenes
