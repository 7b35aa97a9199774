#pragma once
/// The energy balance of a motion, with kinetic energy T, potential energy V and work W done on the
/// mechanism:
///
///     T + V = (T + V at the start) + W,   W' = (power of non-conservative effects) - lambda . nu
///
/// -lambda . nu is the power of drivers, which are rows with a function of time. This file decides which
/// difference between the two sides is too large for an accurate motion (energy_is_lost). A run keeps the
/// largest difference after any step (motion_watch.hpp), and simulation/motion_warnings.cpp warns about it.

#include <cmath>
#include <vector>

#include "constraints/constraint_row.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// Energies at a state, and the work since the start [J].
template <class S>
struct MotionEnergy {
  S kinetic{0}, potential{0};
  S total() const { return kinetic + potential; }
  S work{0};  ///< work of drivers and of non-conservative effects since the start [J]
};

/// |T + V - W - (T + V - W at the start)| [J]: the change of energy that the work does not explain.
template <class S>
S unaccounted_energy(const MotionEnergy<S>& now, const MotionEnergy<S>& at_start) {
  using std::abs;
  return abs(now.total() - at_start.total() - (now.work - at_start.work));
}

/// Whether a run lost or gained energy: its largest unaccounted energy exceeds a thousandth of its largest
/// kinetic energy plus the rounding of energies of the size `energies` [J]. A NaN counts as too large. 1e-3
/// is chosen by experiment: it accepts what usual tolerances cost and reports a motion whose energy visibly
/// changes. 1e-12, about 1e4 u, is the rounding of large energies that cancel. Speeds below 1e-5 of those
/// that belong to `energies` are no motion but rounding, as in a mechanism that its constraints lock;
/// positions then have errors within usual tolerances, 1e-8, which change the potential energy; 1e-7 leaves a
/// margin.
inline bool energy_is_lost(double unaccounted, double largest_kinetic, double energies) {
  constexpr double share_lost = 1e-3, share_rounded = 1e-12, share_at_rest = 1e-10, share_tolerated = 1e-7;
  if (largest_kinetic <= share_at_rest * energies) return !(unaccounted <= share_tolerated * energies);
  return !(unaccounted <= share_lost * largest_kinetic + share_rounded * energies);
}

/// Computes T, V and the power W' of one mechanism. Its drivers are the rows whose function of time is not
/// constant.
template <class S, class Types = StandardTypes>
class EnergyAccount {
 public:
  /// The mechanism must outlive the account.
  explicit EnergyAccount(const Mechanism<S, Types>&&) = delete;
  explicit EnergyAccount(const Mechanism<S, Types>& mechanism) : mechanism_(mechanism) {
    for (int k = 0; k < mechanism_.nc(); ++k)
      if (!function_of(mechanism_.rows[k]).is_constant()) drivers_.push_back(k);
    does_work_ = !drivers_.empty() || !mechanism_.effects.are_conservative();
  }

  bool has_drivers() const { return !drivers_.empty(); }
  /// The rows with a function of time.
  const std::vector<int>& drivers() const { return drivers_; }
  bool does_work() const { return does_work_; }

  /// T and V of the bodies in view; the work is left 0.
  MotionEnergy<S> energy(const EffectView<S>& view) const {
    MotionEnergy<S> energy;
    for (int b = 0; b < mechanism_.nb(); ++b)
      energy.kinetic +=
          kinetic_energy(mechanism_.bodies[b], Twist<S>{view.motion[b].r_dot, view.motion[b].omega_bar});
    energy.potential = mechanism_.effects.potential_energy(view);
    return energy;
  }
  /// W' [W]. `body` holds the same bodies as the view, the ground last.
  template <class Body>
  S power(const EffectView<S>& view, const std::vector<Body>& body, const VectorX<S>& lambda) const {
    return mechanism_.effects.nonconservative_power(view) + drivers_power(body, lambda, view.t);
  }
  /// The power of all drivers, -lambda . nu [W].
  template <class Body>
  S drivers_power(const std::vector<Body>& body, const VectorX<S>& lambda, const S& t) const {
    S sum(0);
    for (const int k : drivers_) {
      const BodyPair pair = bodies_of(mechanism_.rows[k]);
      sum -= lambda[k] * evaluate_row(mechanism_.rows[k], body[pair.i], body[pair.j], t).nu;
    }
    return sum;
  }

 private:
  const Mechanism<S, Types>& mechanism_;
  std::vector<int> drivers_;  ///< rows with a function of time that is not constant
  bool does_work_ = false;
};

}  // namespace trivium
