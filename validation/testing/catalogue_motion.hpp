#pragma once
/// Motions of the catalogue's scenes, kept. A support of the tests.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bodies/numbers/quad.hpp"
#include "formulations/side_by_side.hpp"
#include "scenes/format/scene_file.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/simulate.hpp"

namespace trivium::test {

inline scenes::Scene catalogue_scene(const std::string& name) {
  return scenes::read_scene_file(std::string(TRIVIUM_SCENES_DIR) + "/" + name + ".json");
}

/// The samples of a run.
inline constexpr bool in_quad = true;
struct Motion : SimulationObserver {
  std::vector<MotionSample> samples;
  SimulationReport report;

  Motion(const scenes::Scene& scene, const SimulationOptions& options, bool quad = false) {
    report = quad ? simulate(make_model<Quad>(scene), options, *this)
                  : simulate(make_model<double>(scene), options, *this);
  }
  void sample(const MotionSample& s) override { samples.push_back(s); }
  const MotionSample& end() const { return samples.back(); }
};

inline SimulationOptions tight(const std::string& formulation, const std::string& method, double end,
                               double rtol = 1e-12) {
  SimulationOptions options;
  options.formulation = formulation;
  options.integrator = method;
  options.end = end;
  options.tolerances = {rtol, rtol / 100};
  return options;
}

inline std::string formulation_in_a_name(const testing::TestParamInfo<std::string>& formulation) {
  std::string name = formulation.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace trivium::test
