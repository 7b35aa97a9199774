/// Compiles the comparison of all formulations in double.

#include "formulations/side_by_side_impl.hpp"

#include "bodies/numbers/scalar.hpp"

namespace trivium::detail {
TRIVIUM_FORMULATIONS(TRIVIUM_SOLVE_ONE, double, )
}  // namespace trivium::detail

namespace trivium {
template SideBySide<double> side_by_side<AllFormulations>(const Model<double>&, const RowAnalysis&,
                                                          const SolveOptions&,
                                                          const Model<NextPrecisionT<double>>*);
}  // namespace trivium
