#pragma once
/// Packs states of one mechanism into the lanes of a batch. All lanes are then solved together, in less time
/// than one after the other (docs/cost.md).

#include <span>

#include "bodies/numbers/batch.hpp"
#include "mechanism/mechanism_state.hpp"

namespace trivium {

/// One state whose lane k has the time, poses and twists of states[k].
template <class T, int N>
MechanismState<Batch<T, N>> pack(std::span<const MechanismState<T>, N> states) {
  using Lanes = Batch<T, N>;
  const auto packed = [&]<int size>(const auto& of) {
    Vector<Lanes, size> all;
    for (int n = 0; n < size; ++n)
      for (int lane = 0; lane < N; ++lane) all[n].set(lane, of(states[lane])[n]);
    return all;
  };
  MechanismState<Lanes> all;
  for (int lane = 0; lane < N; ++lane) all.t.set(lane, states[lane].t);
  for (std::size_t b = 0; b < states[0].pose.size(); ++b) {
    all.pose.push_back({packed.template operator()<3>([&](const auto& s) { return s.pose[b].r; }),
                        packed.template operator()<4>([&](const auto& s) { return s.pose[b].p; })});
    all.twist.push_back({packed.template operator()<3>([&](const auto& s) { return s.twist[b].r_dot; }),
                         packed.template operator()<3>([&](const auto& s) { return s.twist[b].omega_bar; })});
  }
  return all;
}

}  // namespace trivium
