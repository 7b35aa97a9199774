/// Compiles the comparison of all formulations in float.

#include "formulations/side_by_side_impl.hpp"

#include "bodies/numbers/scalar.hpp"

namespace trivium {
template SideBySide<float> side_by_side<AllFormulations>(const Model<float>&, const RowAnalysis&,
                                                         const SolveOptions&,
                                                         const Model<NextPrecisionT<float>>*);
}  // namespace trivium
