#include "validation/cost/batch_sweep.hpp"

#include <memory>

#include "bodies/batch_states.hpp"
#include "formulations/acceleration_solver.hpp"
#include "formulations/r_epsilon.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/r_p.hpp"
#include "scenes/mechanism_cast.hpp"

namespace trivium::cost {

namespace {

constexpr int lanes = native_lanes<double>;
using Lanes = Batch<double, lanes>;

template <class F>
struct Data {
  Mechanism<Lanes> mechanism;
  std::vector<std::vector<BodyState<F>>> states;
  AccelerationSolver<F> solver;
  Refinement refinement;

  Data(Mechanism<Lanes> of, Refinement with)
      : mechanism(std::move(of)), solver(mechanism), refinement(with) {}
};

template <class F>
BatchSweep sweep(const Mechanism<double>& mechanism, const std::vector<MechanismState<double>>& states,
                 Refinement refinement) {
  auto data = std::make_shared<Data<F>>(mechanism_cast<Lanes>(mechanism), refinement);
  for (std::size_t n = 0; n < states.size(); n += lanes) {
    const std::span<const MechanismState<double>, lanes> some(states.data() + n, lanes);
    data->states.push_back(to_coordinates<F>(data->mechanism, pack<double, lanes>(some), ChartOptions{}));
  }
  return {lanes,
          [data] {
            for (const auto& state : data->states) data->solver.solve(state, 0, data->refinement);
          },
          [data](int n) {
            data->solver.solve(data->states[static_cast<std::size_t>(n / lanes)], 0, data->refinement);
            std::vector<Vector3> r_ddot;
            for (int b = 0; b < data->mechanism.nb(); ++b) {
              const auto a = lane_of(data->solver.r_ddot(b), n % lanes);
              r_ddot.push_back({a[0], a[1], a[2]});
            }
            return r_ddot;
          }};
}

}  // namespace

BatchSweep batch_sweep(const Mechanism<double>& mechanism, const std::vector<MechanismState<double>>& states,
                       const std::string& formulation, bool refined) {
  const Refinement refinement = refined ? Refinement::once : Refinement::none;
  if (formulation == RP<double>::name) return sweep<RP<Lanes>>(mechanism, states, refinement);
  if (formulation == REpsilon<double>::name) return sweep<REpsilon<Lanes>>(mechanism, states, refinement);
  return sweep<ROmega<Lanes>>(mechanism, states, refinement);
}

}  // namespace trivium::cost
