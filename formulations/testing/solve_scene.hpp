#pragma once
/// A scene solved in all formulations, with row analysis and, on request, error estimates. Support for
/// tests.

#include "bodies/numbers/real50.hpp"
#include "formulations/side_by_side.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium::test {

template <class S>
SideBySide<S> solve_scene(const scenes::Scene& scene, const SolveOptions& options = {},
                          bool estimates_errors = true) {
  const auto rows = analyse_rows(make_model<double>(scene));
  if (!estimates_errors) return side_by_side(make_model<S>(scene), rows, options);
  const auto judge = make_model<NextPrecisionT<S>>(scene);
  return side_by_side(make_model<S>(scene), rows, options, &judge);
}

}  // namespace trivium::test
