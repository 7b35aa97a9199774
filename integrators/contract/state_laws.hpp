#pragma once
/// The laws of a FirstOrderSystem and, where the model has them, of its displacements. C++ types cannot
/// express them. The laws of the equations with multipliers are in laws.hpp, which tests these laws too.

#include <cmath>
#include <limits>
#include <vector>

#include "base/broken_law.hpp"
#include "integrators/contract/displacements.hpp"

namespace trivium::integrators::detail {

/// Evaluates the laws at one state and lists those that do not hold.
template <FirstOrderSystem System>
class StateLaws {
 public:
  using S = typename System::Scalar;
  using Y = StateVector<S>;

  /// The state must meet the constraints.
  StateLaws(System& system, const S& t, const Y& y) : system_(system), t_(t), y_(y) {
    if constexpr (HasDisplacements<System>) {
      nq_ = system.position_size();
      nv_ = system.velocity_size();
      v_ = y.segment(nq_, nv_);
    }
  }

  std::vector<BrokenLaw> broken() {
    first_order();
    corrections();
    if constexpr (HasDisplacements<System>) displacements();
    return broken_;
  }

 protected:
  /// Enters a broken law if a and b differ by more than rounding. The bound, relative to 1 + |a| + |b|, is
  /// `digits_lost` machine epsilons (1e4: four digits are lost). The default leaves room for sums of many
  /// terms of different size. A larger bound hides the loss of a small term.
  void equal(const char* law, const Y& a, const Y& b, double digits_lost = 1e4) {
    const bool same_size = a.size() == b.size();
    const double size = 1 + (same_size ? static_cast<double>(S(a.norm() + b.norm())) : 0.0);
    const double off = same_size ? static_cast<double>(S((a - b).norm())) / size : 1.0;
    const double bound = digits_lost * static_cast<double>(std::numeric_limits<S>::epsilon());
    if (!(off <= bound)) broken_.push_back({law, off, bound});
  }
  void require(const char* law, bool holds) {
    if (!holds) broken_.push_back({law, 1, 0});
  }
  /// Fixed numbers of size up to 1 without a pattern; another seed gives other numbers.
  static Y numbers(int size, int seed) {
    return Y::NullaryExpr(size, [seed](Eigen::Index k) {
      return S(std::sin(static_cast<double>(7 * k + 13 * seed + 1) * 1.7));
    });
  }
  Y with_velocity(const Y& v) const {
    Y y = y_;
    y.segment(nq_, nv_) = v;
    return y;
  }
  /// A state near y; another seed gives another state.
  Y nearby(int seed) const {
    Y off = y_;
    if constexpr (HasDisplacements<System>) {
      system_.displace(y_, S(1e-3) * numbers(nv_, seed), off);
      off.segment(nq_, nv_) += S(1e-3) * (1 + v_.norm()) * numbers(nv_, seed + 1);
    } else {
      off += S(1e-3) * numbers(static_cast<int>(y_.size()), seed);
    }
    system_.normalise(off);
    return off;
  }

  void first_order() {
    require("start has size() entries", system_.start().size() == system_.size());
    require("longest_step is positive", system_.longest_step(t_, y_) > S(0));
    Y y_dot, kept = y_;
    system_.derivative(t_, y_, y_dot);
    require("derivative has size() entries", y_dot.size() == system_.size());
    if (!system_.accept_state(t_, kept))
      equal("accept_state does not change y if it returns false", kept, y_, 0);
    kept = y_;
    system_.normalise(kept);
    equal("normalise does not change a normalised state", kept, y_);
  }
  /// One correction from a nearby state must reduce the violation at least tenfold: the error of a Newton
  /// step is quadratic, and with the matrix of a near state it is linear with a small factor. A violation
  /// below 1e-11, which is far above the rounding of a row in double, need not fall any further.
  void corrections() {
    Y off = nearby(7);
    const auto falls = [&](const char* law, const auto& violation, const auto& correct) {
      const double before = static_cast<double>(violation().size);
      correct();
      system_.normalise(off);
      const double after = static_cast<double>(violation().size), bound = before / 10 + 1e-11;
      if (!(after <= bound)) broken_.push_back({law, after, bound});
    };
    const auto of_positions = [&] { return system_.position_violation(t_, off); };
    const auto of_velocities = [&] { return system_.velocity_violation(t_, off); };
    falls("correct_positions with a new matrix reduces the violation tenfold", of_positions,
          [&] { system_.correct_positions(t_, off, true); });
    falls("a second correct_positions with the same matrix reduces the violation tenfold", of_positions,
          [&] { system_.correct_positions(t_, off, false); });
    falls("correct_velocities with a new matrix reduces the violation tenfold", of_velocities,
          [&] { system_.correct_velocities(t_, off, true); });
    const Y again = nearby(14);
    if constexpr (HasDisplacements<System>)
      off.segment(nq_, nv_) = again.segment(nq_, nv_);  // keeps the corrected positions
    else
      off = again;
    system_.normalise(off);
    falls("a second correct_velocities with the same matrix reduces the violation tenfold", of_velocities,
          [&] { system_.correct_velocities(t_, off, false); });
  }
  void displacements() {
    const Y by = S(0.1) * numbers(nv_, 1), none = Y::Zero(nv_);
    Y to = y_, found, rate, y_dot;
    system_.displace(y_, by, to);
    system_.displacement(y_, to, found);
    equal("displacement recovers the increment of displace", found, by);
    system_.displacement_rate(none, v_, rate);
    equal("displacement_rate at displacement 0 is v", rate, v_);
    // central difference along a motion with v from the displaced state; h and the bound as in laws.hpp
    using std::cbrt;
    const double u = static_cast<double>(std::numeric_limits<S>::epsilon());
    const S h(cbrt(u) / (1 + static_cast<double>(S(v_.norm()))));
    Y ahead = to, behind = to, from_ahead, from_behind;
    system_.position_rate(to, v_, rate);
    ahead.head(nq_) += h * rate;
    behind.head(nq_) -= h * rate;
    system_.displacement(y_, ahead, from_ahead);
    system_.displacement(y_, behind, from_behind);
    system_.displacement_rate(by, v_, rate);
    equal("displacement_rate is the time derivative of displacement", (from_ahead - from_behind) / (2 * h),
          rate, 1e3 * cbrt(u * u) / u);
    system_.position_rate(y_, v_, rate);
    system_.derivative(t_, y_, y_dot);
    equal("position_rate is the position part of derivative", rate, y_dot.head(nq_));
    Y sizes;
    system_.position_sizes(y_, sizes);
    equal("position_sizes are not negative", sizes.cwiseAbs(), sizes, 0);
    require("position_sizes has one entry per velocity", sizes.size() == nv_);
  }

  System& system_;
  const S t_;
  const Y y_;
  int nq_ = 0, nv_ = 0;
  Y v_;
  std::vector<BrokenLaw> broken_;
};

}  // namespace trivium::integrators::detail
