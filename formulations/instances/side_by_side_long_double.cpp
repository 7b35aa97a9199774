#include "formulations/instances/side_by_side_impl.hpp"

#include "bodies/numbers/quad.hpp"

namespace trivium {
template SideBySide<long double> side_by_side(const Model<long double>&, const RowAnalysis&,
                                              const SolveOptions&, const Model<NextPrecisionT<long double>>*);
}  // namespace trivium
