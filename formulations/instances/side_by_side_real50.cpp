/// Compiles the comparison of all formulations in Real50.

#include "formulations/side_by_side_impl.hpp"

#include "bodies/numbers/real50.hpp"

namespace trivium {
template SideBySide<Real50> side_by_side<AllFormulations>(const Model<Real50>&, const RowAnalysis&,
                                                          const SolveOptions&,
                                                          const Model<NextPrecisionT<Real50>>*);
}  // namespace trivium
