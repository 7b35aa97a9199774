#pragma once
/// Sums of the errors that the steps of a motion commit, body by body. The errors count as errors of the
/// points of a body: an angle is multiplied by the reach of the body (mechanism/reach.hpp). lambda does not
/// enter.

#include <algorithm>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "bodies/rotations/so3.hpp"

namespace trivium {

/// What a body does at the end of a step.
template <class S>
struct BodyInMotion {
  Vector3<S> r, v, a;                   ///< position [m], velocity [m/s], acceleration [m/s^2], global
  Vector4<S> p;                         ///< Euler parameters, of either sign
  Vector3<S> omega_bar, omega_bar_dot;  ///< [rad/s, rad/s^2], body frame
};

/// Sums of local errors over the steps of a motion, for the points of the body that errs most in comparison
/// with its size. A sample of the steps is estimated; in each part of a motion the others enter with their
/// mean.
struct LocalErrorSums {
  int body = 0;
  double position = 0;  ///< [m]
  double velocity = 0;  ///< [m/s]
  // of the bodies that are connected with this body
  double size = 0;     ///< extent of their motion [m]
  double speed = 0;    ///< of their fastest point [m/s]
  long steps = 0;      ///< that were estimated
  double unknown = 0;  ///< share of the steps in parts of which none was [-]

  /// The larger of both sums, in comparison with the size and the speed [-].
  double relative() const { return std::max(share(position, size), share(velocity, speed)); }

 private:
  static double share(double error, double whole) { return error > 0 ? error / whole : 0; }
};

/// Adds up the errors of a sample of the steps.
template <class S>
class ErrorSums {
 public:
  /// `reach` of each body: how far its points move by a rotation of 1 rad [m]. `component` of each body: a
  /// number that connected bodies have in common, below the number of bodies.
  ErrorSums(std::vector<S> reach, std::vector<int> component)
      : reach_(std::move(reach)),
        component_(std::move(component)),
        whole_{std::vector<std::pair<S, S>>(reach_.size())},
        part_(whole_),
        begin_(reach_.size()),
        size_(reach_.size(), S(0)),
        speed_(size_) {}

  int bodies() const { return static_cast<int>(reach_.size()); }
  const S& reach(int b) const { return reach_[b]; }
  /// Of the motion of the bodies connected with body b, so far: its extent [m], its fastest point [m/s].
  std::pair<S, S> scale(int b) const { return {size_[component_[b]], speed_[component_[b]]}; }

  /// The motion has reached these positions and velocities. The size of a component is the largest distance
  /// of its points from where its first body began.
  void see(const std::vector<BodyInMotion<S>>& bodies) {
    for (std::size_t b = bodies.size(); !has_seen_ && b-- > 0;) begin_[component_[b]] = bodies[b].r;
    has_seen_ = true;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const BodyInMotion<S>& body = bodies[b];
      raise(size_[component_[b]], S((body.r - begin_[component_[b]]).norm() + reach_[b]));
      raise(speed_[component_[b]], S(body.v.norm() + reach_[b] * body.omega_bar.norm()));
    }
  }
  /// The motion has taken a step.
  void step() { ++part_.steps; }
  /// Adds the errors of every body in one of the steps: `errors_of(b)` is the pair of those of positions [m]
  /// and of velocities [m/s].
  template <class ErrorsOf>
  void add(const ErrorsOf& errors_of) {
    ++part_.estimated;
    for (int b = 0; b < bodies(); ++b) {
      const auto [position, velocity] = errors_of(b);
      part_.errors[b].first += position;
      part_.errors[b].second += velocity;
    }
  }
  /// Whether the present part has an estimate.
  bool part_is_known() const { return part_.estimated > 0; }
  /// A part of the motion ends, after which errors may have another size.
  void end_part() {
    whole_.steps += part_.steps;
    whole_.estimated += part_.estimated;
    if (part_is_known()) {
      known_ += part_.steps;
      const S share = S(static_cast<double>(part_.steps)) / S(static_cast<double>(part_.estimated));
      for (int b = 0; b < bodies(); ++b) {
        whole_.errors[b].first += share * std::exchange(part_.errors[b].first, S(0));
        whole_.errors[b].second += share * std::exchange(part_.errors[b].second, S(0));
      }
    }
    part_.steps = part_.estimated = 0;
  }

  /// The sums for all steps of the parts that have ended. `least` of each body: a bound below which the speed
  /// of the bodies connected with it is no motion [m/s]. `factors` of each body multiply the errors of
  /// positions and of velocities.
  LocalErrorSums sums(const std::vector<double>& least,
                      const std::vector<std::pair<double, double>>& factors) const {
    LocalErrorSums largest;
    const auto steps = static_cast<double>(whole_.steps), known = static_cast<double>(known_);
    const double share = known > 0 ? steps / known : 0;
    for (int b = 0; b < bodies(); ++b) {
      LocalErrorSums of_body;
      of_body.body = b;
      of_body.position = share * factors[b].first * static_cast<double>(whole_.errors[b].first);
      of_body.velocity = share * factors[b].second * static_cast<double>(whole_.errors[b].second);
      of_body.size = static_cast<double>(size_[component_[b]]);
      of_body.speed = std::max(static_cast<double>(speed_[component_[b]]), least[b]);
      of_body.steps = whole_.estimated;
      of_body.unknown = steps > 0 ? 1 - known / steps : 0;
      if (b == 0 || of_body.relative() > largest.relative()) largest = of_body;
    }
    return largest;
  }

 private:
  struct Sums {
    std::vector<std::pair<S, S>> errors;  ///< per body: of positions [m], of velocities [m/s]
    long steps = 0, estimated = 0;
  };

  std::vector<S> reach_;
  std::vector<int> component_;
  Sums whole_, part_;              ///< of the parts that have ended, for all their steps; of the present part
  long known_ = 0;                 ///< steps in parts with an estimate
  std::vector<Vector3<S>> begin_;  ///< per component: where its first body began [m]
  std::vector<S> size_, speed_;    ///< per component, the largest so far [m, m/s]
  bool has_seen_ = false;
};

}  // namespace trivium
