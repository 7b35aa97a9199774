#pragma once
/// The charts of r-epsilon: a sequence and a constant rotation C per body, A = A(epsilon) C.
///
/// C is the identity unless the sequence would stand within |sin theta| (iji) or |cos theta| (ijk) < 0.3 of
/// its singularity; then it is the first of the list below that keeps 0.3 away: quarter turns about x, y, z.
/// One always does, because the quarter turns put three orthogonal directions where the sequence looks.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "bodies/numbers/lanewise.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/so3.hpp"
#include "formulations/formulation.hpp"

namespace trivium {

/// One member of the list: its name and axis, -1 for the identity.
struct Reframing {
  std::string_view name;
  int axis;
};
inline constexpr std::array<Reframing, 4> reframings{
    {{"I", -1}, {"Rx(90)", 0}, {"Ry(90)", 1}, {"Rz(90)", 2}}};
inline constexpr double reframing_distance = 0.3;

template <class S>
struct EulerChart {
  EulerSequence sequence;
  int reframing = 0;  ///< its place in the list; of a batch, that of one lane
  Matrix3<S> C = Matrix3<S>::Identity();

  /// "313" or "313 Rx(90)".
  std::string name() const {
    return reframing == 0 ? sequence.name() : sequence.name() + " " + std::string(reframings[reframing].name);
  }
};

/// A quarter turn of the list, exact: its entries are 0 and +-1.
template <class S>
Matrix3<S> reframing_rotation(int index) {
  const int k = reframings[index].axis;
  Matrix3<S> C = Matrix3<S>::Identity();
  if (k < 0) return C;
  const int m = (k + 1) % 3, n = (k + 2) % 3;
  C(m, m) = C(n, n) = S(0);
  C(m, n) = S(-1);
  C(n, m) = S(1);
  return C;
}

/// The chart of that name; returns whether there is one.
template <class S>
bool read_chart(std::string_view name, EulerChart<S>& chart) {
  const auto sequence = parse_euler_sequence(name.substr(0, 3));
  if (!sequence) return false;
  for (int index = 0; index < static_cast<int>(reframings.size()); ++index) {
    chart = {*sequence, index, reframing_rotation<S>(index)};
    if (chart.name() == name) return true;
  }
  return false;
}

/// |sin theta| (iji) or |cos theta| (ijk) of A(epsilon): 0 where the sequence is singular, from the entries
/// of A.
template <class S>
S distance_from_singularity(const EulerSequence& s, const Matrix3<S>& A) {
  using std::sqrt;
  const auto [i, j, k] = s.axis;
  const int first = s.is_symmetric() ? j : i, second = s.is_symmetric() ? 3 - i - j : j;
  return sqrt(A(i, first) * A(i, first) + A(i, second) * A(i, second));
}

/// The chart for a body at p. With reframe off the identity, whatever the distance; a chart closer than a few
/// u to its singularity has no rates at all and is a ModelError.
template <class S>
EulerChart<S> choose_euler_chart(const ChartOptions& options, const Vector4<S>& p) {
  const Matrix3<S> A = rotation_matrix(p);
  EulerChart<S> chart{options.sequence};
  if (!options.reframe) {
    const S distance = distance_from_singularity<S>(options.sequence, A);
    if (any(distance <= 16 * unit_roundoff<S>()))
      throw ModelError(fmt::format(
          "the {} chart is singular here ({} = {:.1e}); leave re-framing on or choose another sequence",
          options.sequence.name(), options.sequence.is_symmetric() ? "|sin theta|" : "|cos theta|",
          static_cast<double>(distance)));
    return chart;
  }
  // the first of the list that is far enough
  S farthest(0);
  for (int index = static_cast<int>(reframings.size()) - 1; index >= 0; --index) {
    const Matrix3<S> C = reframing_rotation<S>(index);
    const S distance = distance_from_singularity<S>(options.sequence, A * C.transpose());
    const auto is_far = distance >= S(reframing_distance);
    if (any(is_far)) chart.reframing = index;
    for (int k = 0; k < 9; ++k) chart.C(k) = select(is_far, C(k), chart.C(k));
    farthest = select(distance > farthest, distance, farthest);
  }
  if (!all(farthest >= S(reframing_distance)))
    throw ModelError("no chart found: the orientation is not a rotation");
  return chart;
}

}  // namespace trivium
