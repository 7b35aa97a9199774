/// Two runs in two threads of one process do not disturb each other: each gives the same numbers as it does
/// alone. Built with the thread sanitizer, the program also fails if there was a data race.

#include <cstdio>
#include <functional>
#include <thread>
#include <vector>

#include "trivium/trivium.hpp"

namespace {

using Numbers = std::vector<double>;

/// Positions and multipliers at all outputs of a motion.
Numbers motion(const std::string& scene, const trivium::SimulateSettings& settings) {
  Numbers all;
  trivium::simulate(trivium::read_scene(scene), settings, [&](const trivium::Output& at) {
    for (const trivium::BodyInstant& body : at.bodies) all.insert(all.end(), body.r.begin(), body.r.end());
    all.insert(all.end(), at.lambda.begin(), at.lambda.end());
    return true;
  });
  return all;
}

Numbers state(const std::string& scene, const std::string& formulation) {
  return trivium::solve(trivium::read_scene(scene), {.formulation = formulation}).lambda;
}

/// Whether both calls give the same numbers in two threads at once as one after the other.
bool together(const char* what, const std::function<Numbers()>& one, const std::function<Numbers()>& other) {
  const Numbers one_alone = one(), other_alone = other();
  Numbers one_beside, other_beside;
  std::thread first([&] { one_beside = one(); }), second([&] { other_beside = other(); });
  first.join();
  second.join();
  const bool are_the_same = one_alone == one_beside && other_alone == other_beside && !one_alone.empty();
  std::printf("%s: %s\n", what, are_the_same ? "the same" : "DIFFERS");
  return are_the_same;
}

}  // namespace

int main(int, char** argv) {
  const std::string folder = argv[1];
  const auto scene = [&](const char* name) { return folder + "/" + name + ".json"; };
  const auto run = [&](const char* name, const char* formulation, const char* integrator) {
    return [=] {
      return motion(scene(name),
                    {.formulation = formulation, .integrator = integrator, .end = 0.05, .output_step = 0.01});
    };
  };
  bool passed = together("one scene, one method", run("spatial_slider_crank", "r-p", "dopri5"),
                         run("spatial_slider_crank", "r-p", "dopri5"));
  passed = together("two scenes, implicit methods", run("four_bar", "r-omega", "radau5"),
                    run("heavy_top", "r-p", "radau9")) &&
           passed;
  passed = together("motions by libraries", run("heavy_top", "r-omega", "cvode-bdf"),
                    run("heavy_top", "r-p", "ida")) &&
           passed;
  passed = together(
               "states", [&] { return state(scene("stewart_platform"), "r-p"); },
               [&] { return state(scene("n_four_bar_2"), "r-epsilon"); }) &&
           passed;
  return passed ? 0 : 1;
}
