/// Every component of the state is changed at random, in r-omega, and the result is projected. A projection
/// can remove most of the change; the distance is therefore measured afterwards.

#include "simulation/neighbouring_start.hpp"

#include <algorithm>
#include <random>

#include "base/raise.hpp"
#include "bodies/rotations/so3.hpp"
#include "formulations/analysis/consistency.hpp"
#include "formulations/r_omega.hpp"
#include "integrators/projection_iteration.hpp"
#include "simulation/system/first_order_equations.hpp"

namespace trivium {

double turn_between(const Vector4<double>& p, const Vector4<double>& q) {
  return 2 * std::min((p - q).norm(), (p + q).norm());
}

namespace {

/// Limits of the relative distance [-], chosen by experiment. The smallest is about 1e5 u, far above rounding
/// errors. The largest keeps the neighbour near if the tolerances are loose.
constexpr double least_distance = 1e-11, largest_distance = 1e-4;

/// The length [m], speed [m/s] and angular velocity [rad/s] to which differences of states are relative.
struct Scales {
  double length = 0, speed = 0, rate = 0;

  explicit Scales(const Model<double>& model) {
    const Extent extent = extent_of(model.mechanism, model.state);
    length = extent.length > 0 ? extent.length : 1;
    speed = extent.speed;
    for (const Twist<double>& twist : model.state.twist) raise(rate, twist.omega_bar.norm());
    // a mechanism at rest: its length per second, as it begins to move within about a second
    if (!(speed > 0)) speed = length;
    if (!(rate > 0)) rate = speed / length;
  }
};

double distance(const Scales& scales, const MechanismState<double>& a, const MechanismState<double>& b) {
  double largest = 0;
  for (std::size_t n = 0; n < a.pose.size(); ++n) {
    raise(largest, (a.pose[n].r - b.pose[n].r).norm() / scales.length);
    raise(largest, turn_between(a.pose[n].p, b.pose[n].p));
    raise(largest, (a.twist[n].r_dot - b.twist[n].r_dot).norm() / scales.speed);
    raise(largest, (a.twist[n].omega_bar - b.twist[n].omega_bar).norm() / scales.rate);
  }
  return largest;
}

/// A state at a relative distance of about `size` from the model's state that satisfies the constraints. The
/// state vector of the formulation r-omega is changed at random and then projected, as after a step.
MechanismState<double> neighbour(FirstOrderEquations<ROmega<double>>& equations, double t,
                                 const Scales& scales, int seed, double size) {
  // the distribution depends on the standard library: a seed gives the same numbers on one platform only
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto draw = [&](double scale) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    return Vector3<double>(scale * size * Vector3<double>(x, y, z));
  };
  VectorX<double> y = equations.start();
  for (int b = 0; b < equations.nb(); ++b) {
    auto place = equations.layout().place(y, b);
    auto rate = equations.layout().rate(y, b);
    place.head<3>() += draw(scales.length);
    const Vector3<double> half = draw(0.5);
    Vector4<double> turn(1, half[0], half[1], half[2]);
    turn.normalize();
    place.tail<4>() = multiply_parameters(Vector4<double>(place.tail<4>()), turn);
    rate.head<3>() += draw(scales.speed);
    rate.tail<3>() += draw(scales.rate);
  }
  integrators::ProjectionReport<double> report;
  integrators::ProjectionIteration<FirstOrderEquations<ROmega<double>>>()(equations, t, y, report);
  return equations.to_mechanism_state(t, y);
}

}  // namespace

NeighbouringStart neighbouring_start(const Model<double>& model, double tolerance, int seed,
                                     double in_tolerances) {
  const Scales scales(model);
  FirstOrderEquations<ROmega<double>> equations(model.mechanism, model.state);
  double size = std::clamp(in_tolerances * tolerance, least_distance, largest_distance);
  for (int tries = 3;; size /= 30) {  // 3 and 30 are chosen by experiment: the last distance is size / 900
    try {
      NeighbouringStart start{neighbour(equations, model.state.t, scales, seed, size), 0};
      // The projection has removed nearly the whole change: the constraints leave no neighbour, and the rest
      // is an error of the projection. The factor 1e-3 is a safety factor.
      if (const double apart = distance(scales, start.state, model.state); apart > 1e-3 * size)
        start.distance = apart;
      return start;
    } catch (const Error&) {
      if (--tries == 0) throw;
    }
  }
}

}  // namespace trivium
