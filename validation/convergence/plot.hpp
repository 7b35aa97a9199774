#pragma once
/// Draws errors against step size, with triangles of the published slopes. A method has its published order
/// where its curve is parallel to its triangle.

#include <string>
#include <vector>

#include "validation/convergence/observed_orders.hpp"

namespace trivium::convergence {

/// Draws one scene in one formulation to an SVG file with gnuplot: one panel for each quantity, one curve for
/// each method.
void plot(const std::vector<OrderResult>& rows, const std::string& scene, const std::string& formulation,
          const std::string& file);

}  // namespace trivium::convergence
