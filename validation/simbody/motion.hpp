#pragma once
/// The motion of a model by Simbody's own integrators. Plain C++17, like model.hpp.

#include <array>
#include <vector>

#include "validation/simbody/way.hpp"

namespace trivium::simbody {

/// Those that control their errors: all but a semi-explicit Euler at given steps.
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

/// Where a body is and how it moves: p of e0 first, omega_bar in the body frame.
struct BodyState {
  Vector3 r{};
  std::array<double, 4> p{};
  Vector3 r_dot{}, omega_bar{};
};

struct Motion {
  std::vector<std::vector<BodyState>> states;  ///< of all bodies, at every time asked for
  double seconds = 0;                          ///< of this thread's CPU, from the first state to the last
  long steps = 0, realizations = 0;
};

/// Through the times, which steps end at but for those of CPodes, that interpolates; constraints to the
/// accuracy. Throws Refused, and nothing else.
Motion move(const Model& model, Way way, Integrator integrator, double accuracy,
            const std::vector<double>& times);

}  // namespace trivium::simbody
