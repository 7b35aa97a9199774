#pragma once
/// The charts of r-epsilon: an Euler sequence and a constant rotation C per body, A = A(epsilon) C.
///
/// The distance of a chart from its singularity is |sin theta| (sequences iji) or |cos theta| (ijk). C is the
/// identity if the distance is then at least 0.3; otherwise C is the first quarter turn about x, y or z whose
/// distance is at least 0.3. Such a C always exists. The distance is sqrt(1 - a^2), where a is an entry in
/// row i of A C^T and i the first axis of the sequence. A quarter turn exchanges two columns of A, up to
/// signs. So the four choices of C give |a| the magnitudes of all three entries in row i of A, one of them
/// twice. The smallest of these is at most 1/sqrt(3), which gives a distance of at least sqrt(2/3).

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

/// A re-framing rotation C: its name and its axis (0, 1, 2), or -1 for the identity.
struct Reframing {
  std::string_view name;
  int axis;
};
/// The re-framing rotations in the order of preference.
inline constexpr std::array<Reframing, 4> reframings{
    {{"I", -1}, {"Rx(90)", 0}, {"Ry(90)", 1}, {"Rz(90)", 2}}};
/// Least distance of a chart from its singularity. The error of lambda grows as u / theta^3 (r_epsilon.hpp),
/// so it stays below about 40 u; with a larger value a motion would change charts more often.
inline constexpr double reframing_distance = 0.3;

/// The chart of a body: an Euler sequence and the re-framing rotation C.
template <class S>
struct EulerChart {
  EulerSequence sequence;
  int reframing = 0;  ///< index of C in reframings; for a batch of states, the index of one lane
  Matrix3<S> C = Matrix3<S>::Identity();

  /// The sequence and, unless C is the identity, the re-framing: "313" or "313 Rx(90)".
  std::string name() const {
    return reframing == 0 ? sequence.name() : sequence.name() + " " + std::string(reframings[reframing].name);
  }
};

/// The rotation C of an entry of reframings, exact: its entries are 0 and +-1.
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

/// Reads a chart from its name; returns false if no chart has this name.
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

/// |sin theta| (iji) or |cos theta| (ijk) of A = A(epsilon) [-], computed from the entries of A; 0 at the
/// singularity.
template <class S>
S distance_from_singularity(const EulerSequence& s, const Matrix3<S>& A) {
  using std::sqrt;
  const auto [i, j, k] = s.axis;
  const int first = s.is_symmetric() ? j : i, second = s.is_symmetric() ? 3 - i - j : j;
  return sqrt(A(i, first) * A(i, first) + A(i, second) * A(i, second));
}

/// The chart for a body with Euler parameters p. With options.reframe off, C is the identity at any
/// distance; then a distance of at most 16 u, about its rounding, throws a ModelError: D has no usable
/// inverse.
template <class S>
EulerChart<S> choose_euler_chart(const ChartOptions& options, const Vector4<S>& p) {
  const Matrix3<S> A = rotation_matrix(p);
  EulerChart<S> chart{options.sequence};
  if (!options.reframe) {
    const S distance = distance_from_singularity<S>(options.sequence, A);
    if (any(distance <= 16 * unit_roundoff<S>()))
      throw ModelError(fmt::format(
          "the chart of the Euler-angle sequence {} is singular at this orientation ({} = {:.1e}); leave "
          "re-framing on or choose another sequence",
          options.sequence.name(), options.sequence.is_symmetric() ? "|sin theta|" : "|cos theta|",
          static_cast<double>(distance)));
    return chart;
  }
  // the loop runs backwards, so the first entry at a distance of at least 0.3 is stored last
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
    throw ModelError("no chart found: the Euler parameters do not describe a rotation (zero or not finite)");
  return chart;
}

}  // namespace trivium
