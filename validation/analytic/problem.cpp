/// Simulates the scene of a problem by Fehlberg's method at tolerances far below the bounds of its errors.

#include "validation/analytic/problem.hpp"

#include "scenes/catalogue.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/simulate.hpp"

namespace trivium::analytic {

std::vector<MotionSample> motion(const scenes::Scene& scene, const std::string& formulation, double end,
                                 double output_step) {
  Samples samples;
  SimulationOptions options;
  options.formulation = formulation;
  options.integrator = "rkf78";
  options.end = end;
  options.output_step = output_step;
  options.tolerances = {1e-12, 1e-14};
  simulate(make_model<double>(scene), options, samples);
  return samples.all;
}

scenes::Scene catalogue_scene(const std::string& name) { return load_scene(name, 0); }

}  // namespace trivium::analytic
