/// Compiles the comparison of all formulations in Quad.

#include "formulations/side_by_side_impl.hpp"

#include "bodies/numbers/real50.hpp"

namespace trivium {
template SideBySide<Quad> side_by_side<AllFormulations>(const Model<Quad>&, const RowAnalysis&,
                                                        const SolveOptions&,
                                                        const Model<NextPrecisionT<Quad>>*);
}  // namespace trivium
