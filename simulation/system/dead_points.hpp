#pragma once
/// Ends a motion that comes to rest where a driver has lost its own gradient, as a driven distance that falls
/// to 0. The driver can push in either direction there, and no velocity says which way the motion goes on.
/// Where the gradient nearly vanishes, a step may lead to the wrong side. Dead points that depend on other
/// rows are singular positions (motion_log.hpp).

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
  /// that pass the point. A gradient that turns round within a step was not followed by it. This counts from
  /// a share of 1e-4 on if the motion has slowed down as it does on its way to rest, to the root of this
  /// share.
  template <class Types, class Body>
  void check(const Mechanism<S, Types>& mechanism, const std::vector<int>& drivers,
             const std::vector<Body>& body, const S& t) {
    using std::sqrt;
    drivers_.resize(drivers.size());
    for (std::size_t k = 0; k < drivers.size(); ++k) {
      const auto& constraint = mechanism.rows[drivers[k]];
      const BodyPair pair = bodies_of(constraint);
      const Body &i = body[pair.i], &j = body[pair.j];
      const auto row = evaluate_row(constraint, i, j, t);
      Gradient gradient(row.r_i.size() + row.r_j.size() + row.rot_i.size() + row.rot_j.size());
      gradient << row.r_i, row.r_j, row.rot_i, row.rot_j;
      const auto squared = [](const Body& of) { return of.r_dot.squaredNorm() + of.omega_bar.squaredNorm(); };
      const Size size{gradient.norm(), sqrt(squared(i) + squared(j))};
      Driver& known = drivers_[k];
      raise(known.largest.gradient, size.gradient);
      raise(known.largest.speed, size.speed);
      const auto is_below = [&](const Size& one, double gradient_share, double speed_share) {
        return one.gradient < S(gradient_share) * known.largest.gradient &&
               one.speed < S(speed_share) * known.largest.speed;
      };
      const auto end = [&](const char* cause) {
        throw ModelError(
            {fmt::format("driver \"{}\"", mechanism.row_names[drivers[k]]), static_cast<double>(t)}, cause);
      };
      if (is_below(size, 1e-8, 1e-4))
        end("the motion comes to rest where this row has lost its gradient: it is at a dead point and can "
            "go on in either direction. Give the driver another function of time, or drive another joint");
      if (known.gradient.size() > 0 && known.gradient.dot(gradient) < S(0) &&
          (is_below(size, 1e-4, 1e-2) || is_below(known.size, 1e-4, 1e-2)))
        end("the motion nearly comes to rest where this row nearly loses its gradient, which turned round "
            "within the last step: it may have gone on to the wrong side of a dead point. Take smaller "
            "steps, or give the driver another function of time");
      known.gradient = gradient;
      known.size = size;
    }
  }

 private:
  struct Size {
    S gradient{0}, speed{0};  ///< |Phi_q|, and the root of the bodies' |r'|^2 + |omega_bar|^2
  };
  /// Of both bodies, with at most four numbers of rotation each.
  using Gradient = Eigen::Matrix<S, 1, Eigen::Dynamic, Eigen::RowMajor, 1, 14>;
  struct Driver {
    Size largest, size;  ///< so far, and at the last state
    Gradient gradient;   ///< at the last state
  };
  std::vector<Driver> drivers_;
};

}  // namespace trivium
