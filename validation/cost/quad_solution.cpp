/// Solves by the structured solver in quad. Where this solver fails, the printed system is solved in quad
/// instead.

#include "validation/cost/quad_solution.hpp"

#include <algorithm>
#include <cmath>

#include "base/raise.hpp"
#include "bodies/numbers/real50.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/side_by_side.hpp"
#include "validation/cost/trivium_engine.hpp"

namespace trivium::cost {

namespace {

QuadSolution as_printed(const scenes::Scene& scene) {
  SolveOptions options;
  options.formulations = {std::string(ROmega<Quad>::name)};
  const SideBySide<Quad> printed =
      side_by_side(make_model<Quad>(scene), analyse_rows(make_model<double>(scene)), options);
  const auto& only = printed.formulations.front();
  if (!only.error.empty()) throw ModelError(only.error);
  QuadSolution exact;
  for (const auto& v : only.solution.r_ddot) exact.r_ddot.push_back(plain<Quad>(v));
  exact.lambda = plain<Quad>(only.solution.lambda);
  exact.unique = printed.rows.unique;
  return exact;
}

}  // namespace

double QuadSolution::error_of(const std::vector<Vector3>& other) const {
  double difference = 0, size = 0;
  for (std::size_t b = 0; b < r_ddot.size(); ++b) {
    const Vector3 &x = r_ddot[b], &y = other[b];
    const double d = std::hypot(y[0] - x[0], y[1] - x[1], y[2] - x[2]);
    raise(difference, d);
    raise(size, std::hypot(x[0], x[1], x[2]));
  }
  return difference == 0 ? 0 : difference / size;
}

double QuadSolution::lambda_error_of(const std::vector<double>& other) const {
  double difference = 0, size = 0;
  for (std::size_t k = 0; k < lambda.size(); ++k) {
    if (!unique[k]) continue;
    difference += (other[k] - lambda[k]) * (other[k] - lambda[k]);
    size += lambda[k] * lambda[k];
  }
  return difference == 0 ? 0 : std::sqrt(difference / size);
}

QuadSolution quad_solution(const scenes::Scene& scene) {
  try {
    TriviumEngine<ROmega<Quad>> quad(scene, Refined::yes);
    quad.evaluate();
    // The analysis of unique multipliers is made in double: quad is not needed and would take long.
    return {quad.r_ddot(), quad.lambda(), unique_multipliers(scene)};
  } catch (const ModelError&) {
    return as_printed(scene);
  }
}

}  // namespace trivium::cost
