#pragma once
/// The errors of positions for which the cost of accuracy is reported. The table that work_precision prints
/// and the table of the paper both use this list. The errors range from a rough simulation to the smallest
/// error that Trivium and Simbody both reach in every scene with a margin.

#include <array>

namespace trivium {

inline constexpr std::array position_targets{1e-3, 1e-6, 1e-9, 1e-10};  ///< [m]

}  // namespace trivium
