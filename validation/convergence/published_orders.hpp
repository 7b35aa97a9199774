#pragma once
/// The published order of every method, for r, v and lambda and for the method's own ("raw") lambda. This
/// file also decides which runs show this order: the scene, the number of steps, and the smallest error that
/// is not rounding.

#include <string>
#include <vector>

#include "integrators/method_parameters.hpp"

namespace trivium::convergence {

struct Case {
  std::string label, method;
  integrators::MethodParameters parameters;
  int order, raw_order;  ///< order of the method's raw lambda; 0 if it is not observed
  /// Number of steps of the coarsest run, chosen by experiment: all errors show their order, and those of the
  /// finest run are above rounding.
  int steps;
  bool is_double = false;  ///< the method belongs to a library that computes in double only
  /// The scene that is used if the command line names none. hedop5 has double_pendulum, since on the
  /// slider-crank some of its errors first fall faster than its order.
  std::string scene = "spatial_slider_crank";
  /// Errors below this fraction of their quantity show no order [-]. In quad the limit is the difference
  /// between initial states: the scene's positions are doubles, and projections onto the constraints differ
  /// by their rounding.
  double floor = 1e-16;
};

/// All methods with given steps; methods with a choice of orders at each order that shows its slope.
std::vector<Case> cases();

}  // namespace trivium::convergence
