#pragma once
/// Errors over steps as a figure, with triangles of the published slopes. A method has its order where its
/// line is parallel to its triangle.

#include <string>
#include <vector>

#include "validation/convergence/observed_orders.hpp"

namespace trivium::convergence {

/// Draws to an SVG file, by gnuplot: a panel a quantity and a line a method, of one scene in one formulation.
void plot(const std::vector<OrderResult>& rows, const std::string& scene, const std::string& formulation,
          const std::string& file);

}  // namespace trivium::convergence
