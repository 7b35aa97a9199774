#pragma once
/// The errors of positions that the cost of accuracy is told for. work_precision's table on the screen and
/// the paper's are made for the same ones.

#include <array>

namespace trivium {

inline constexpr std::array position_targets{1e-3, 1e-6, 1e-9, 1e-10};  ///< [m]

}  // namespace trivium
