#pragma once
/// A problem whose solution is known: the largest error of each quantity over its motion, and the bound that
/// the error is held to. The bounds stand where the quantities are compared.

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

/// What a problem is compared in, one after the other.
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

/// Compares the motion of one formulation with the known solution.
struct Problem {
  std::string name;
  std::function<void(const std::string&, Errors&)> compare;
};

/// The motion by Fehlberg's method at a relative tolerance of 1e-12, from the scene's state at time 0.
std::vector<MotionSample> motion(const scenes::Scene& scene, const std::string& formulation, double end,
                                 double output_step);

scenes::Scene catalogue_scene(const std::string& name);

}  // namespace trivium::analytic
