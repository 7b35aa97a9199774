#include <fmt/format.h>

#include <cmath>

#include "scenes/scene_checks.hpp"

namespace trivium::scenes {
namespace {

/// The parts of a function are there, to a depth that its file may have.
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

 private:
  /// A container at this place is one level deeper than its path is long.
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

}  // namespace

void check_function(const TimeFunction& f, const Path& at) {
  std::visit(PartChecks(at), f.kind());
  const Jet<double> jet = f(0.0);
  if (!std::isfinite(jet.f) || !std::isfinite(jet.f_t) || !std::isfinite(jet.f_tt))
    fail(at, fmt::format("f, f', f'' = {}, {}, {} at t = 0", jet.f, jet.f_t, jet.f_tt),
         "a function whose value and derivatives are finite");
}

}  // namespace trivium::scenes
