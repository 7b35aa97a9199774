#pragma once
/// One-page models with known solutions for tests of methods: motion without constraints, and a particle on a
/// circle. They show which functions a model of the contract must have.

#include <cmath>
#include <functional>
#include <string>

#include "integrators/contract/first_order_system.hpp"

namespace trivium::integrators::test {

/// y' = f(t, y) without constraints.
struct Free {
  using Scalar = double;
  std::function<StateVector<double>(double, const StateVector<double>&)> f;
  StateVector<double> y0;
  double longest = 1e300;
  int settled = 0, changes_at = -1;  ///< number of the accepted state at which coordinates change

  int size() const { return static_cast<int>(y0.size()); }
  StateVector<double> start() const { return y0; }
  void derivative(double t, const StateVector<double>& y, StateVector<double>& y_dot) { y_dot = f(t, y); }
  Violation<double> position_violation(double, const StateVector<double>&) { return {}; }
  Violation<double> velocity_violation(double, const StateVector<double>&) { return {}; }
  bool projection_is_too_large(const StateVector<double>&, const StateVector<double>&,
                               const StateVector<double>&) const {
    return false;
  }
  double longest_step(double, const StateVector<double>&) const { return longest; }
  void correct_positions(double, StateVector<double>&, bool) {}
  void correct_velocities(double, StateVector<double>&, bool) {}
  void normalise(StateVector<double>&) {}
  std::string row_name(int) const { return "none"; }
  bool accept_state(double, StateVector<double>&) { return settled++ == changes_at; }
  bool pass_discontinuity(double, double, StateVector<double>&) { return false; }
  std::string diagnose(double, const StateVector<double>&, double) { return {}; }
  std::string most_accelerated(double, const StateVector<double>&) { return {}; }
};

/// A particle (x, y, x', y') on the unit circle at constant speed: Phi = (x^2 + y^2 - 1) / 2.
struct OnACircle : Free {
  double factored_x = 0, factored_y = 0;
  bool stuck = false;  ///< corrections have no effect
  int factors = 0;

  explicit OnACircle(double speed = 1) {
    y0 = Eigen::Vector4d(1, 0, 0, speed);
    f = [](double, const StateVector<double>& y) {
      const double pull = (y[2] * y[2] + y[3] * y[3]) / (y[0] * y[0] + y[1] * y[1]);
      return StateVector<double>(Eigen::Vector4d(y[2], y[3], -pull * y[0], -pull * y[1]));
    };
  }
  static double phi(const StateVector<double>& y) { return (y[0] * y[0] + y[1] * y[1] - 1) / 2; }
  static double phi_dot(const StateVector<double>& y) { return y[0] * y[2] + y[1] * y[3]; }
  Violation<double> position_violation(double, const StateVector<double>& y) {
    return {std::abs(phi(y)), std::abs(phi(y)), 0};
  }
  Violation<double> velocity_violation(double, const StateVector<double>& y) {
    return {std::abs(phi_dot(y)), std::abs(phi_dot(y)), 0};
  }
  void correct_positions(double, StateVector<double>& y, bool factor) { correct(y, 0, phi(y), factor); }
  void correct_velocities(double, StateVector<double>& y, bool factor) { correct(y, 2, phi_dot(y), factor); }
  bool projection_is_too_large(const StateVector<double>& before, const StateVector<double>& stepped,
                               const StateVector<double>& projected) const {
    return !((projected - stepped).norm() <= (stepped - before).norm() / 10 + 1e-4);
  }
  std::string row_name(int) const { return "circle"; }

 private:
  void correct(StateVector<double>& y, int part, double left, bool factor) {
    if (factor) {
      factored_x = y[0];
      factored_y = y[1];
      ++factors;
    }
    if (stuck) return;
    const double size = factored_x * factored_x + factored_y * factored_y;
    y[part] -= left * factored_x / size;
    y[part + 1] -= left * factored_y / size;
  }
};

}  // namespace trivium::integrators::test
