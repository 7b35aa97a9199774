#pragma once
/// The tolerance by which a mechanism decides which of its constraint rows are dependent. Scenes may have
/// another one than the standard; the tolerances that follow from it are in
/// formulations/analysis/rank_tolerance.hpp.

namespace trivium {

/// Singular values of the geometrically scaled Jacobian, relative to the largest, below which a row counts as
/// dependent. Geometric scaling divides the columns of rotations by a mean lever [m], the root mean square of
/// |Phi_pi_bar| / |Phi_r| over connected bodies, and then each row by its norm. The value lies between the
/// defect that rounded or nearly consistent positions leave in a dependent row (1e-16 to 1e-9) and the
/// smallest singular value of a real mechanism.
inline constexpr double standard_rank_tolerance = 1e-8;

/// The least tolerance that a scene may have. Below it rounding would decide.
inline constexpr double least_rank_tolerance = 1e-14;
/// The largest one. The structured solver examines a row only if the sine between its gradient and the span
/// of the other rows may be below 1e-4 (examined_joint_row_tolerance; dependent_pivot is its square). With a
/// larger tolerance it would keep rows that the dense analysis calls dependent.
inline constexpr double largest_rank_tolerance = 1e-4;

}  // namespace trivium
