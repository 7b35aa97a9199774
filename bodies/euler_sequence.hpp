#pragma once
/// The twelve body-fixed sequences of Euler angles, as run-time data.

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace trivium {

/// Successive body-fixed axes s1, s2, s3 (0 = x, 1 = y, 2 = z): A = R_s1(a) R_s2(b) R_s3(c).
struct EulerSequence {
  std::array<int, 3> axis{2, 0, 2};

  /// iji: singular where sin(theta) = 0. The others (ijk) are singular where cos(theta) = 0.
  constexpr bool is_symmetric() const { return axis[0] == axis[2]; }
  /// "313" and the like.
  std::string name() const {
    std::string s;
    for (int a : axis) s += static_cast<char>('1' + a);
    return s;
  }
  bool operator==(const EulerSequence&) const = default;
};

inline constexpr std::array<std::string_view, 12> euler_sequence_names{
    "121", "131", "212", "232", "313", "323", "123", "132", "213", "231", "312", "321"};

/// The sequence of that name; none if it is not one of the twelve.
inline std::optional<EulerSequence> parse_euler_sequence(std::string_view name) {
  for (std::string_view known : euler_sequence_names)
    if (name == known) return EulerSequence{{name[0] - '1', name[1] - '1', name[2] - '1'}};
  return std::nullopt;
}

}  // namespace trivium
