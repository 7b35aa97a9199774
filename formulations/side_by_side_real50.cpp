#include "formulations/side_by_side_impl.hpp"

namespace trivium {
template SideBySide<Real50> solve_side_by_side(const scenes::Scene&, double, const SolveOptions&);
}  // namespace trivium
