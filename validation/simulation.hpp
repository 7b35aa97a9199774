#pragma once
/// A scene's motion in one formulation by one method, both chosen by name.

#include <optional>
#include <string>
#include <vector>

#include "formulations/first_order_form.hpp"
#include "formulations/reaction.hpp"
#include "integrators/integrate.hpp"
#include "scenes/scene.hpp"

namespace trivium {

struct SimulationOptions {
  std::string formulation = "r-omega", integrator = "dopri5";
  double start = 0, end = 10;
  std::optional<double> step;         ///< else the method chooses, to the tolerances
  std::optional<double> output_step;  ///< else the start and the end
  integrators::Tolerances tolerances;
  bool projects = true;
  std::optional<Baumgarte> baumgarte;
  ChartOptions charts;
};

/// What a run shows at an output, in double whatever it computes in.
struct MotionSample {
  MechanismState<double> state;
  std::vector<Reaction<double>> reactions;  ///< on body j of every joint: global, about its point on i
  VectorX<double> lambda;       ///< of redundant rows those of minimum |E lambda|, where they can be had
  double energy = 0;            ///< kinetic and potential [J]
  double phi = 0, phi_dot = 0;  ///< largest violation of any row, m or rad (per second)
};

struct SimulationReport {
  double reached = 0;
  bool complete = false;  ///< not stopped from outside
  integrators::Counters counters;
  long factorisations = 0;
  bool is_projected = true;
  integrators::ProjectionReport<double> projection;
  int reframings = 0;
  double phi = 0, phi_dot = 0;              ///< largest after any step
  double normalisation = 0;                 ///< largest |p . p - 1| after any step
  double energy_start = 0, energy_end = 0;  ///< kinetic and potential [J]
  bool does_work = false;
  double work = 0;             ///< of drivers, and of effects as far as it is not stored [J]
  double balance = 0;          ///< largest change of energy that this work does not account for [J]
  double largest_kinetic = 0;  ///< what that is large beside [J]
  std::vector<SingularPassage> passages;
};

/// Sees a run go by. `step` is asked after every step whether to go on.
class SimulationObserver {
 public:
  virtual ~SimulationObserver() = default;
  virtual void sample(const MotionSample&) {}
  virtual bool step(double /*t*/) { return true; }
};

/// The formulations that can be simulated.
std::vector<std::string> simulated_formulations();

/// From the scene's state, taken as that at `start`. Throws a ModelError or an IntegrationError that says
/// where and why it ended; the samples until then were shown.
template <class Scalar>
SimulationReport simulate(const scenes::Scene& scene, const SimulationOptions& options,
                          SimulationObserver& observer);

// compiled once each
template <Formulation F>
SimulationReport simulate_in(const scenes::Scene& scene, const SimulationOptions& options,
                             SimulationObserver& observer);

}  // namespace trivium
