/// Compiles the comparison of all formulations in long double.

#include "formulations/side_by_side_impl.hpp"

#include "bodies/numbers/quad.hpp"

namespace trivium {
template SideBySide<long double> side_by_side<AllFormulations>(const Model<long double>&, const RowAnalysis&,
                                                               const SolveOptions&,
                                                               const Model<NextPrecisionT<long double>>*);
}  // namespace trivium
