#pragma once
/// A problem with a known solution: the largest error of each compared quantity over the motion, and its
/// bound. The bounds are stated in the code that compares the quantities. They are chosen by experiment,
/// above the error of the motion or of the known solution.

#include <functional>
#include <string>
#include <vector>

#include "base/raise.hpp"
#include "scenes/scene.hpp"
#include "simulation/motion.hpp"

namespace trivium::analytic {

using Vector = Vector3<double>;

struct Check {
  std::string problem, formulation, quantity;
  double error, bound;
  bool passed() const { return error <= bound; }
};

/// The errors of all quantities of one problem, in the order of their first comparison.
struct Errors {
  void raise(const std::string& quantity, double error, double bound) {
    for (Check& c : checks)
      if (c.quantity == quantity) {
        trivium::raise(c.error, error);
        return;
      }
    checks.push_back({"", "", quantity, error, bound});
  }
  std::vector<Check> checks;
};

/// A problem; `compare` compares the motion in one formulation with the known solution.
struct Problem {
  std::string name;
  std::function<void(const std::string&, Errors&)> compare;
};

/// The motion from the scene's state at time 0, by Fehlberg's method (rkf78) with a relative tolerance of
/// 1e-12.
std::vector<MotionSample> motion(const scenes::Scene& scene, const std::string& formulation, double end,
                                 double output_step);

scenes::Scene catalogue_scene(const std::string& name);

}  // namespace trivium::analytic
