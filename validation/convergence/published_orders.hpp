#pragma once
/// The order that is published of every method, of r, v and lambda and of the method's own lambda. Decided
/// here: the runs that show this order, by scene, steps, and the size down to which errors tell an order.

#include <string>
#include <vector>

#include "integrators/method_parameters.hpp"

namespace trivium::convergence {

struct Case {
  std::string label, method;
  integrators::MethodParameters parameters;
  int order, raw_order;  ///< of the method's own lambda; 0: it has none
  int steps;             ///< of the coarsest run
  /// Where the mass matrix depends on the position the order falls, to between 1 and what it is elsewhere.
  bool needs_constant_mass = false;
  bool is_double = false;  ///< of a library that computes in double alone: errors stay above its rounding
  /// Where it is measured unless scenes are named: on the slider-crank some errors first fall faster.
  std::string scene = "spatial_slider_crank";
  /// An error tells an order where it is above this share of what it is an error of: in quad, starts differ
  /// as projections of a scene's doubles do.
  double floor = 1e-16;
};

/// All methods that take given steps, at every order that is theirs to choose.
std::vector<Case> cases();

}  // namespace trivium::convergence
