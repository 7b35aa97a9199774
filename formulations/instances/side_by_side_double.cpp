#include "formulations/instances/side_by_side_impl.hpp"

#include "bodies/numbers/scalar.hpp"

namespace trivium {
template SideBySide<double> side_by_side(const Model<double>&, const RowAnalysis&, const SolveOptions&,
                                         const Model<NextPrecisionT<double>>*);
}  // namespace trivium
