/// The settings and runs of Simbody's integrators (declared in runs.hpp).

#include <algorithm>
#include <iterator>

#include "bodies/numbers/scalar.hpp"
#include "validation/precision/runs.hpp"
#include "validation/simbody/motion.hpp"
#include "validation/simbody/translation.hpp"

namespace trivium::precision {

namespace {

/// Simbody's integrators with their names, and the finest accuracy that is affordable with the order of each.
constexpr struct Peer {
  const char* name;
  simbody::Integrator which;
  double finest;
} peers[] = {{"ExplicitEuler", simbody::Integrator::explicit_euler, 1e-3},
             {"SemiExplicitEuler2", simbody::Integrator::semi_explicit_euler_2, 1e-3},
             {"Verlet", simbody::Integrator::verlet, 1e-4},
             {"RungeKutta2", simbody::Integrator::runge_kutta_2, 1e-4},
             {"RungeKutta3", simbody::Integrator::runge_kutta_3, 1e-5},
             {"RungeKuttaMerson", simbody::Integrator::runge_kutta_merson, 0},
             {"RungeKuttaFeldberg", simbody::Integrator::runge_kutta_feldberg, 0},
             {"CPodes Adams", simbody::Integrator::cpodes_adams, 0},
             {"CPodes BDF", simbody::Integrator::cpodes_bdf, 0}};

simbody::Integrator integrator_of(const std::string& method) {
  return std::find_if(std::begin(peers), std::end(peers),
                      [&](const Peer& peer) { return method == peer.name; })
      ->which;
}

Vector3<double> vector(const simbody::Vector3& v) { return {v[0], v[1], v[2]}; }

}  // namespace

std::vector<RunSettings> peer_settings(bool quick) {
  std::vector<RunSettings> all;
  std::vector<double> accuracies = tolerances(quick);
  if (!quick) accuracies.insert(accuracies.end(), finest_tolerances.begin(), finest_tolerances.end());
  for (const Peer& peer : peers)
    for (const double accuracy : accuracies)
      if (accuracy >= peer.finest) all.push_back({"Simbody", "", peer.name, accuracy, {}});
  return all;
}

PeerMotion peer_motion(const TimedMotion& motion, const RunSettings& settings) {
  const simbody::Motion found =
      simbody::move(to_simbody(motion.scene, motion.model()), simbody::Way::mobilizers,
                    integrator_of(settings.method), *settings.rtol, output_times(motion));
  PeerMotion out{{}, found.seconds, found.steps, found.realizations};
  for (const auto& bodies : found.states) {
    MechanismState<double>& state = out.states.emplace_back();
    for (const simbody::BodyState& body : bodies) {
      state.pose.push_back({vector(body.r), {body.p[0], body.p[1], body.p[2], body.p[3]}});
      state.twist.push_back({vector(body.r_dot), vector(body.omega_bar)});
    }
  }
  return out;
}

}  // namespace trivium::precision
