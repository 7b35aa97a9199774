/// Packs as many states as a Scalar has lanes, solves them together, and unpacks the accelerations.

#include "validation/cost/state_sweep.hpp"

#include <memory>
#include <span>

#include "base/error.hpp"
#include "formulations/equations_of_motion_impl.hpp"
#include "formulations/structured/acceleration_solver_impl.hpp"
#include "formulations/structured/graph_solver_impl.hpp"
#include "mechanism/mechanism_cast.hpp"
#include "mechanism/state_batch.hpp"
#include "validation/cost/trivium_engine.hpp"
#include "validation/harness/timed_formulations.hpp"

namespace trivium::cost {

namespace {

/// The number of states that a Scalar holds, and functions that pack and unpack them.
template <class S>
struct Lanes;
template <>
struct Lanes<double> {
  static constexpr int count = 1;
  static MechanismState<double> pack(std::span<const MechanismState<double>, 1> state) { return state[0]; }
  static trivium::Vector3<double> of(const trivium::Vector3<double>& v, int) { return v; }
};
template <int N>
struct Lanes<Batch<double, N>> {
  static constexpr int count = N;
  static auto pack(std::span<const MechanismState<double>, N> states) {
    return trivium::pack<double, N>(states);
  }
  static trivium::Vector3<double> of(const trivium::Vector3<Batch<double, N>>& v, int lane) {
    return lane_of(v, lane);
  }
};

template <class F>
class Sweep {
 public:
  using S = typename F::Scalar;

  Sweep(const Mechanism<double>& mechanism, Refinement refinement)
      : mechanism_(mechanism_cast<S>(mechanism)), solver_(mechanism_), refinement_(refinement) {}

  void take(const States& states) {
    states_.clear();
    for (std::size_t n = 0; n < states.size(); n += lanes) {
      const std::span<const MechanismState<double>, lanes> some(states.data() + n, lanes);
      states_.push_back(to_coordinates<F>(mechanism_, Lanes<S>::pack(some), ChartOptions{}));
    }
  }

  void all() {
    for (const auto& state : states_) solver_.solve(state, S(0), refinement_);
  }
  std::vector<Vector3> r_ddot(int n) {
    solver_.solve(states_[static_cast<std::size_t>(n / lanes)], S(0), refinement_);
    std::vector<Vector3> r_ddot;
    for (int b = 0; b < mechanism_.nb(); ++b)
      r_ddot.push_back(plain<double>(Lanes<S>::of(solver_.r_ddot(b), n % lanes)));
    return r_ddot;
  }

 private:
  static constexpr int lanes = Lanes<S>::count;

  Mechanism<S> mechanism_;
  std::vector<std::vector<BodyState<F>>> states_;
  AccelerationSolver<F> solver_;
  Refinement refinement_;
};

template <class S>
StateSweep sweep_in(const Mechanism<double>& mechanism, const std::string& formulation, Refined refined) {
  return with_formulation<S, TimedFormulations>(formulation, [&]<class F>() {
    const auto sweep = std::make_shared<Sweep<F>>(mechanism, refinement_of(refined));
    return StateSweep{[sweep](const States& states) { sweep->take(states); }, [sweep] { sweep->all(); },
                      [sweep](int n) { return sweep->r_ddot(n); }};
  });
}

}  // namespace

StateSweep one_by_one(const Mechanism<double>& mechanism, const std::string& formulation, Refined refined) {
  return sweep_in<double>(mechanism, formulation, refined);
}

StateSweep in_batches(const Mechanism<double>& mechanism, const std::string& formulation, Refined refined) {
  return sweep_in<Batch<double, register_lanes>>(mechanism, formulation, refined);
}

}  // namespace trivium::cost
