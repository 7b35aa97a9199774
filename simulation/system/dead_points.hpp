#pragma once
/// Ends a motion that comes to rest where a driver has lost its own gradient, as a driven distance that falls
/// to 0. The driver can push in either direction there, and no velocity says which way the motion goes on.
/// Dead points that depend on other rows are singular positions (motion_log.hpp).

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/raise.hpp"
#include "constraints/constraint_row.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// Watches the drivers of one motion.
template <class S>
class DeadPoints {
 public:
  /// Notes an accepted state at time t; `body` holds the bodies, the ground last. Throws a ModelError that
  /// names the driver. Shares [-] of the largest values so far: a gradient below 1e-8, half of a double's
  /// digits, does not tell its direction any more; 1e-4 of the speed is chosen by experiment, to meet steps
  /// that pass the point.
  template <class Types, class Body>
  void check(const Mechanism<S, Types>& mechanism, const std::vector<int>& drivers,
             const std::vector<Body>& body, const S& t) {
    using std::sqrt;
    largest_.resize(drivers.size());
    for (std::size_t k = 0; k < drivers.size(); ++k) {
      const auto& constraint = mechanism.rows[drivers[k]];
      const BodyPair pair = bodies_of(constraint);
      const Body &i = body[pair.i], &j = body[pair.j];
      const auto row = evaluate_row(constraint, i, j, t);
      const S gradient = sqrt(row.r_i.squaredNorm() + row.r_j.squaredNorm() + row.rot_i.squaredNorm() +
                              row.rot_j.squaredNorm());
      const auto squared = [](const Body& of) { return of.r_dot.squaredNorm() + of.omega_bar.squaredNorm(); };
      const S speed = sqrt(squared(i) + squared(j));
      Driver& largest = largest_[k];
      raise(largest.gradient, gradient);
      raise(largest.speed, speed);
      if (gradient < S(1e-8) * largest.gradient && speed < S(1e-4) * largest.speed)
        throw ModelError(
            {fmt::format("driver \"{}\"", mechanism.row_names[drivers[k]]), static_cast<double>(t)},
            "the motion comes to rest where this row has lost its gradient: it is at a dead "
            "point and can go on in either direction. Give the driver another function of "
            "time, or drive another joint");
    }
  }

 private:
  struct Driver {
    S gradient{0}, speed{0};  ///< |Phi_q|, and the root of the bodies' |r'|^2 + |omega_bar|^2
  };
  std::vector<Driver> largest_;  ///< so far
};

}  // namespace trivium
