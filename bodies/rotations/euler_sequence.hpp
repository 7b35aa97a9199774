#pragma once
/// The twelve body-fixed sequences of Euler angles, A = R_s1(a) R_s2(b) R_s3(c), as run-time data. A sequence
/// is singular where its middle angle makes the first and the third axis parallel. The caller sets the
/// sequence (ChartOptions); euler_chart_choice.hpp chooses the constant rotation C of each body's chart.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace trivium {

/// A sequence of Euler angles: the axes of its three successive rotations.
struct EulerSequence {
  std::array<int, 3> axis{2, 0, 2};  ///< body-fixed axes s1, s2, s3 (0 = x, 1 = y, 2 = z); default 3-1-3

  /// Whether the sequence is iji, singular where sin(theta) = 0 with theta the middle angle. The others (ijk)
  /// are singular where cos(theta) = 0.
  constexpr bool is_symmetric() const { return axis[0] == axis[2]; }
  /// The axes as digits from 1, e.g. "313".
  std::string name() const {
    std::string s;
    for (int a : axis) s += static_cast<char>('1' + a);
    return s;
  }
  bool operator==(const EulerSequence&) const = default;
};

/// The axes of a sequence as compile-time constants, numbered as in EulerSequence.
template <int i, int j, int k>
using Axes = std::integer_sequence<int, i, j, k>;

/// Returns `use(Axes<i, j, k>{})`: passes the axes as compile-time constants, so that matrix columns which
/// they select need no run-time index.
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

/// The names of the twelve sequences: six iji, then six ijk.
inline constexpr std::array<std::string_view, 12> euler_sequence_names{
    "121", "131", "212", "232", "313", "323", "123", "132", "213", "231", "312", "321"};

/// The sequence with that name; none if the name is not one of the twelve.
inline std::optional<EulerSequence> parse_euler_sequence(std::string_view name) {
  for (std::string_view known : euler_sequence_names)
    if (name == known) return EulerSequence{{name[0] - '1', name[1] - '1', name[2] - '1'}};
  return std::nullopt;
}

}  // namespace trivium
