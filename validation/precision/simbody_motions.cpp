#include "bodies/scalar.hpp"
#include "validation/precision/contest.hpp"
#include "validation/simbody_translation.hpp"

namespace trivium::precision {

namespace {

simbody::Integrator integrator_of(const std::string& method) {
  if (method == "RungeKuttaMerson") return simbody::Integrator::runge_kutta_merson;
  if (method == "RungeKuttaFeldberg") return simbody::Integrator::runge_kutta_feldberg;
  if (method == "CPodes Adams") return simbody::Integrator::cpodes_adams;
  return simbody::Integrator::cpodes_bdf;
}

Vector3<double> vector(const simbody::Vector3& v) { return {v[0], v[1], v[2]}; }

}  // namespace

std::vector<Entry> peer_entries(bool quick) {
  std::vector<Entry> all;
  std::vector<double> accuracies = tolerances(quick);
  if (!quick) accuracies.insert(accuracies.end(), finest_tolerances.begin(), finest_tolerances.end());
  for (const char* method : {"RungeKuttaMerson", "RungeKuttaFeldberg", "CPodes Adams", "CPodes BDF"})
    for (const double accuracy : accuracies) all.push_back({"Simbody", "", method, accuracy, {}});
  return all;
}

PeerMotion peer_motion(const TimedMotion& motion, const Entry& entry) {
  const simbody::Motion found = simbody::move(to_simbody(motion.scene, 0), simbody::Way::mobilizers,
                                              integrator_of(entry.method), *entry.rtol, output_times(motion));
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
