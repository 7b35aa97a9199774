#pragma once
/// Simulates a model with Simbody's own integrators. Plain C++17, like model.hpp.

#include <array>
#include <limits>
#include <vector>

#include "validation/simbody/way.hpp"

namespace trivium::simbody {

/// All of Simbody's integrators that control their error. SemiExplicitEuler, which takes given steps, is left
/// out.
enum class Integrator {
  explicit_euler,
  semi_explicit_euler_2,
  verlet,
  runge_kutta_2,
  runge_kutta_3,
  runge_kutta_merson,
  runge_kutta_feldberg,
  cpodes_adams,
  cpodes_bdf
};

/// Pose and velocity of a body: p with e0 first; r and r_dot in the global frame, omega_bar in the body
/// frame.
struct BodyState {
  Vector3 r{};
  std::array<double, 4> p{};
  Vector3 r_dot{}, omega_bar{};
};

struct Motion {
  std::vector<std::vector<BodyState>> states;  ///< states of all bodies at every requested time
  double seconds = 0;                          ///< CPU time of this thread for the integration [s]
  long steps = 0, realizations = 0;
};

/// A run that was ended because it takes too many steps.
class GivenUp : public Refused {
 public:
  using Refused::Refused;
};

/// The motion at the given times. Steps end at these times, except that CPodes interpolates. Constraints are
/// satisfied to `accuracy`; no step is longer than `longest` [s]. Throws GivenUp after `most_steps`, Refused
/// if the integrator ends, and no other exception.
Motion move(const Model& model, Way way, Integrator integrator, double accuracy,
            const std::vector<double>& times, double longest = std::numeric_limits<double>::infinity(),
            int most_steps = 200'000);

}  // namespace trivium::simbody
