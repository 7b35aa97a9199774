#pragma once
/// The twelve body-fixed sequences of Euler angles, as run-time data: A = R_s1(a) R_s2(b) R_s3(c). Each is
/// singular where its middle angle makes the first and the third axis parallel; euler_chart_choice.hpp
/// decides which sequence a body gets.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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

template <int i, int j, int k>
using Axes = std::integer_sequence<int, i, j, k>;

/// use(Axes<i, j, k>{}): the axes as constants, for code that would look columns up by them.
template <class Use>
auto with_axes(const EulerSequence& sequence, const Use& use) {
  const auto from = [&]<int i>(std::integral_constant<int, i>) {
    constexpr int next = (i + 1) % 3, last = (i + 2) % 3;
    if (sequence.axis[1] == next)
      return sequence.is_symmetric() ? use(Axes<i, next, i>{}) : use(Axes<i, next, last>{});
    return sequence.is_symmetric() ? use(Axes<i, last, i>{}) : use(Axes<i, last, next>{});
  };
  switch (sequence.axis[0]) {
    case 0:
      return from(std::integral_constant<int, 0>{});
    case 1:
      return from(std::integral_constant<int, 1>{});
    default:
      return from(std::integral_constant<int, 2>{});
  }
}

inline constexpr std::array<std::string_view, 12> euler_sequence_names{
    "121", "131", "212", "232", "313", "323", "123", "132", "213", "231", "312", "321"};

/// The sequence of that name; none if it is not one of the twelve.
inline std::optional<EulerSequence> parse_euler_sequence(std::string_view name) {
  for (std::string_view known : euler_sequence_names)
    if (name == known) return EulerSequence{{name[0] - '1', name[1] - '1', name[2] - '1'}};
  return std::nullopt;
}

}  // namespace trivium
