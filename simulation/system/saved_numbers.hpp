#pragma once
/// The part of FirstOrderEquations that takes up a saved run: it restores the numbers y, the charts, the
/// counted joint angles and the fastest speeds, and refuses a saved run that does not fit the mechanism.

#include <string>
#include <utility>
#include <vector>

#include "formulations/body_state.hpp"
#include "mechanism/saved_run.hpp"
#include "simulation/system/constraint_projection.hpp"

namespace trivium {

/// The name of every body's chart; empty in formulations without charts.
template <Formulation F>
std::vector<std::string> chart_names(const std::vector<BodyState<F>>& bodies) {
  std::vector<std::string> names;
  for (const BodyState<F>& body : bodies)
    if (const std::string chart(body.chart.name()); !chart.empty()) names.push_back(chart);
  return names;
}

/// The joint angles that effects counted last [rad], in the order of the effects. They are within 1 rad of
/// the angles at the last accepted state (JointAngle::tracked).
template <class S, class Types>
std::vector<double> counted_angles(Mechanism<S, Types>& mechanism) {
  std::vector<double> angles;
  mechanism.effects.for_each_angle(
      [&](const JointAngle<S>& angle) { angles.push_back(static_cast<double>(angle.tracked)); });
  return angles;
}

/// Throws an Error of kind input.
[[noreturn]] inline void refuse_saved_run(const std::string& mechanism, const SavedRun& saved,
                                          const std::string& why) {
  throw Error(ErrorKind::input, {mechanism, saved.t},
              fmt::format("the saved run cannot be continued: {}; without the key \"saved\" a new run starts "
                          "from the state of the bodies",
                          why));
}

/// Returns the saved y, and restores charts in `bodies`, counted angles in `mechanism`, and fastest speeds in
/// `projection`. Throws an Error if the saved run ended at another time than that of `state`, if its y does
/// not have `size` numbers, or if its other numbers do not fit the mechanism.
template <Formulation F>
VectorX<typename F::Scalar> restore_numbers(const SavedRun& saved, MechanismOf<F>& mechanism,
                                            const MechanismState<typename F::Scalar>& state, int size,
                                            std::vector<BodyState<F>>& bodies,
                                            ConstraintProjection<F>& projection) {
  using S = typename F::Scalar;
  const auto refuse = [&](const std::string& why) { refuse_saved_run(mechanism.name, saved, why); };
  if (static_cast<double>(state.t) != saved.t)
    refuse(fmt::format("the state is taken at t = {}", static_cast<double>(state.t)));
  if (static_cast<int>(saved.y.size()) != size)
    refuse(fmt::format("y has {} entries, but a state of {} bodies in {} has {}", saved.y.size(),
                       mechanism.nb(), F::name, size));
  for (int b = 0; b < mechanism.nb(); ++b) {
    const std::string chart = saved.charts.empty() ? std::string() : saved.charts[b];
    bool is_known = false;
    if constexpr (requires { read_chart(chart, bodies[b].chart); })
      is_known = read_chart(chart, bodies[b].chart);
    if (!is_known)
      refuse(
          fmt::format("{} has no chart \"{}\", or the name does not define it completely", F::name, chart));
  }
  std::size_t counted = 0;
  mechanism.effects.for_each_angle([&](JointAngle<S>& angle) {
    if (counted < saved.angles.size()) angle.tracked = S(saved.angles[counted]);
    ++counted;
  });
  if (counted != saved.angles.size())
    refuse(fmt::format("the saved run has {} angles, the effects track {}", saved.angles.size(), counted));
  if (!projection.measure().set_fastest(saved.fastest))
    refuse(fmt::format("the number of entries of \"fastest\", {}, does not fit the mechanism",
                       saved.fastest.size()));
  VectorX<S> y(size);
  for (int k = 0; k < size; ++k) y[k] = S(saved.y[k]);
  return y;
}

/// Throws an Error if a body of the scene is not where the saved numbers have it: the body was edited in the
/// file, and the saved numbers no longer describe the scene.
template <class S, class Types>
void check_bodies_as_saved(const SavedRun& saved, const Mechanism<S, Types>& mechanism,
                           const MechanismState<S>& state, const MechanismState<S>& of_numbers) {
  // 17 digits in a file keep a double, and normalising p may change the last bits; 1e-12 is far above both
  const auto is_near = [](const auto& x, const auto& y) {
    return S((x - y).norm()) <= S(1e-12) * S(x.norm());
  };
  for (int b = 0; b < mechanism.nb(); ++b) {
    const Pose<S>&pose = state.pose[b], &kept = of_numbers.pose[b];
    const Twist<S>&twist = state.twist[b], &kept_twist = of_numbers.twist[b];
    if (!(is_near(pose.r, kept.r) && is_near(pose.p, kept.p) && is_near(twist.r_dot, kept_twist.r_dot) &&
          is_near(twist.omega_bar, kept_twist.omega_bar)))
      refuse_saved_run(mechanism.name, saved,
                       fmt::format("body \"{}\" was moved or given another velocity since the run was saved",
                                   mechanism.body_names[b]));
  }
}

}  // namespace trivium
