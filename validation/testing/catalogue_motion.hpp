#pragma once
/// Motions of the catalogue's scenes, stored for tests, and the parameterised tests that every formulation
/// must pass. For tests only. Limits in tests of motions are chosen by experiment, with a margin, unless a
/// comment gives another reason.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/raise.hpp"
#include "bodies/numbers/quad.hpp"
#include "formulations/side_by_side.hpp"
#include "integrators/methods.hpp"
#include "scenes/format/scene_file.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/testing/catalogue_scene.hpp"
#include "simulation/simulate.hpp"

namespace trivium::test {

/// A scene of the folder wellformed/, whose scenes use every word of the format.
inline scenes::Scene wellformed_scene(const std::string& name) {
  return scenes::read_scene_file(fmt::format("{}/wellformed/{}.json", TRIVIUM_TEST_SCENES_DIR, name));
}

/// A scene of the folder hard/, on which a run once failed.
inline scenes::Scene hard_scene(const std::string& name) {
  return scenes::read_scene_file(fmt::format("{}/hard/{}.json", TRIVIUM_TEST_SCENES_DIR, name));
}

/// The samples and the report of a run, in double, or in quad if the last argument is `in_quad`.
inline constexpr bool in_quad = true;
struct Motion : SimulationObserver {
  std::vector<MotionSample> samples;
  SimulationReport report;

  Motion(const scenes::Scene& scene, const SimulationOptions& options, bool quad = false) {
    report = quad ? simulate(make_model<Quad>(scene), options, *this)
                  : simulate(make_model<double>(scene), options, *this);
  }
  bool sample(const MotionSample& s) override {
    samples.push_back(s);
    return true;
  }
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

inline SimulationOptions stepping(const std::string& formulation, const std::string& method, double end,
                                  double step) {
  SimulationOptions options;
  options.formulation = formulation;
  options.integrator = method;
  options.end = end;
  options.step = step;
  return options;
}

/// The largest distance [m] between a body's positions at the ends of two motions.
inline double apart(const Motion& a, const Motion& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.end().state.pose.size(); ++k)
    raise(largest, (a.end().state.pose[k].r - b.end().state.pose[k].r).norm());
  return largest;
}

/// Methods with given steps that satisfy the position constraints by their own equations, for any mass
/// matrix.
inline const std::vector<std::string> implicit_methods = [] {
  std::vector<std::string> names;
  for (const integrators::MethodInfo& method : integrators::methods())
    if (method.takes_given_steps && method.meets_constraints && !method.needs_constant_inertia)
      names.emplace_back(method.name);
  return names;
}();

/// Tests with the name of a formulation as parameter. motions_test.cpp and implicit_motions_test.cpp
/// instantiate them for all files.
class InEveryFormulation : public testing::TestWithParam<std::string> {};
class Implicit : public testing::TestWithParam<std::string> {};

inline std::string formulation_in_a_name(const testing::TestParamInfo<std::string>& formulation) {
  std::string name = formulation.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace trivium::test
