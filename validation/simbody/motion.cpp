/// Makes Simbody's integrators, and records poses and velocities at the output times.

#include "validation/simbody/motion.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <mutex>

#include "simulation/cpu_time.hpp"
#include "validation/simbody/system.hpp"

namespace trivium::simbody {

namespace {

using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::SpatialVec;

/// Redirects stderr to /dev/null as long as one of them exists in any thread. CPodes writes thousands of
/// lines there; failures are reported by exceptions or by the result anyway.
class SilentErrors {
 public:
  SilentErrors() {
    const std::lock_guard lock(guard_);
    if (count_++ > 0) return;
    std::fflush(stderr);
    kept_ = ::dup(STDERR_FILENO);
    const int nowhere = ::open("/dev/null", O_WRONLY);
    if (kept_ >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) ::close(nowhere);
  }
  ~SilentErrors() {
    const std::lock_guard lock(guard_);
    if (--count_ > 0) return;
    std::fflush(stderr);
    if (kept_ < 0) return;
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
  }
  SilentErrors(const SilentErrors&) = delete;
  SilentErrors& operator=(const SilentErrors&) = delete;

 private:
  static inline std::mutex guard_;
  static inline int count_ = 0, kept_ = -1;
};

/// The integrator returns after so many steps, to be given up.
constexpr int steps_at_once = 10'000;

std::unique_ptr<SimTK::Integrator> make(const System& system, Integrator which) {
  switch (which) {
    case Integrator::explicit_euler:
      return std::make_unique<SimTK::ExplicitEulerIntegrator>(system.multibody);
    case Integrator::semi_explicit_euler_2:
      return std::make_unique<SimTK::SemiExplicitEuler2Integrator>(system.multibody);
    case Integrator::verlet:
      return std::make_unique<SimTK::VerletIntegrator>(system.multibody);
    case Integrator::runge_kutta_2:
      return std::make_unique<SimTK::RungeKutta2Integrator>(system.multibody);
    case Integrator::runge_kutta_3:
      return std::make_unique<SimTK::RungeKutta3Integrator>(system.multibody);
    case Integrator::runge_kutta_merson:
      return std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system.multibody);
    case Integrator::runge_kutta_feldberg:
      return std::make_unique<SimTK::RungeKuttaFeldbergIntegrator>(system.multibody);
    case Integrator::cpodes_adams:
      return std::make_unique<SimTK::CPodesIntegrator>(system.multibody, SimTK::CPodes::Adams);
    case Integrator::cpodes_bdf:
      return std::make_unique<SimTK::CPodesIntegrator>(system.multibody, SimTK::CPodes::BDF);
  }
  return nullptr;
}

void read_states(const System& system, Motion& out) {
  system.multibody.realize(system.state, SimTK::Stage::Velocity);
  std::vector<BodyState> states;
  for (int b = 0; b < static_cast<int>(system.model.bodies.size()); ++b) {
    const MobilizedBody& body = system.bodies[b];
    const Rotation& R = body.getBodyRotation(system.state);
    const SimTK::Quaternion q = R.convertRotationToQuaternion();
    const SpatialVec& V = body.getBodyVelocity(system.state);
    states.push_back({array(body.getBodyOriginLocation(system.state)),
                      {q[0], q[1], q[2], q[3]},
                      array(V[1]),
                      array(~R * V[0])});
  }
  out.states.push_back(states);
}

Motion move(System& system, Integrator which, double accuracy, const std::vector<double>& times,
            double longest, int most_steps) {
  const std::unique_ptr<SimTK::Integrator> integrator = make(system, which);
  integrator->setAccuracy(accuracy);
  integrator->setConstraintTolerance(accuracy);
  // CPodes interpolates as accurately as it steps; the Runge-Kutta methods interpolate only by a cubic.
  const bool interpolates = which == Integrator::cpodes_adams || which == Integrator::cpodes_bdf;
  integrator->setAllowInterpolation(interpolates);
  integrator->setInternalStepLimit(steps_at_once);
  if (std::isfinite(longest)) integrator->setMaximumStepSize(longest);
  Motion out;
  const SilentErrors silent;
  const double start = cpu_seconds();
  integrator->initialize(system.state);
  for (const double t : times) {
    while (integrator->getTime() < t) {
      integrator->stepTo(t, interpolates ? SimTK::Infinity : t);
      if (integrator->getNumStepsTaken() > most_steps)
        throw GivenUp(fmt::format("more than {} steps up to t = {:g}", most_steps, integrator->getTime()));
    }
    system.state = integrator->getState();
    read_states(system, out);
  }
  out.seconds = cpu_seconds() - start;
  out.steps = integrator->getNumStepsTaken();
  out.realizations = integrator->getNumRealizations();
  return out;
}

}  // namespace

Motion move(const Model& model, Way way, Integrator integrator, double accuracy,
            const std::vector<double>& times, double longest, int most_steps) {
  try {
    System system(model, way);
    return move(system, integrator, accuracy, times, longest, most_steps);
  } catch (const Refused&) {
    throw;
  } catch (const std::exception& error) {
    throw Refused(on_one_line(error.what()));
  }
}

}  // namespace trivium::simbody
