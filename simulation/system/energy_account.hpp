#pragma once
/// The account of energy along a motion: T + V at a state, and the work W that is done on the mechanism,
///
///   T + V = (T + V at the start) + W,   W' = (power of effects that they do not take from V) - lambda . nu
///
/// where -lambda . nu is the power of drivers, rows whose right side nu of the velocities moves. Here it is
/// decided which difference between both sides is too large for an accurate motion (energy_is_lost). A run
/// keeps the largest difference after any step (motion_watch.hpp); the program warns of it
/// (trivium/command/motion_report.cpp).

#include <cmath>
#include <vector>

#include "constraints/constraint_row.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// [J]
template <class S>
struct MotionEnergy {
  S kinetic{0}, potential{0};
  S total() const { return kinetic + potential; }
  S work{0};  ///< since the start, of drivers and of what effects do not take from stored energy
};

/// |T + V - (T + V at the start) - W| [J]: what the work does not account for.
template <class S>
S unaccounted_energy(const MotionEnergy<S>& now, const MotionEnergy<S>& at_start) {
  using std::abs;
  return abs(now.total() - at_start.total() - now.work);
}

/// Whether a run lost or gained energy: the largest difference that its work does not account for is more
/// than a thousandth of the largest kinetic energy, and than rounding of the energies, whose largest is
/// `energies`. A difference that is not a number is too large.
inline bool energy_is_lost(double unaccounted, double largest_kinetic, double energies) {
  constexpr double share_lost = 1e-3, share_rounded = 1e-12;
  return !(unaccounted <= share_lost * largest_kinetic + share_rounded * energies);
}

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
  bool does_work() const { return does_work_; }

  /// T and V of the bodies in view.
  MotionEnergy<S> energy(const EffectView<S>& view) const {
    MotionEnergy<S> energy;
    for (int b = 0; b < mechanism_.nb(); ++b)
      energy.kinetic +=
          kinetic_energy(mechanism_.bodies[b], Twist<S>{view.motion[b].r_dot, view.motion[b].omega_bar});
    energy.potential = mechanism_.effects.potential_energy(view);
    return energy;
  }
  /// W' [W]. The bodies, the ground last, are those in view.
  template <class Body>
  S power(const EffectView<S>& view, const std::vector<Body>& body, const VectorX<S>& lambda) const {
    return mechanism_.effects.nonconservative_power(view) + drivers_power(body, lambda, view.t);
  }
  /// -lambda . nu
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
  std::vector<int> drivers_;  ///< rows that move by themselves
  bool does_work_ = false;
};

}  // namespace trivium
