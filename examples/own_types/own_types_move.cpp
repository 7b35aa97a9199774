/// Example: a user-written constraint and a user-written effect, added to the mechanism of a scene. The
/// constraint keeps a point of a body in a turning plane; the effect is drag proportional to the square of
/// the speed. Fails if one of them breaks its laws, if lambda differs between the formulations, if
/// constraints drift, if work does not explain the energy, or if the motions in r-p and in r-omega differ.
///
///   own_types_move SCENE...

#include <fmt/format.h>
#include <base/raise.hpp>
#include <constraints/constraint_laws.hpp>
#include <effects/effect_laws.hpp>
#include <formulations/analysis/row_analysis_impl.hpp>
#include <formulations/equations_of_motion_impl.hpp>
#include <formulations/printed/augmented_solver_impl.hpp>
#include <formulations/printed/error_estimate_impl.hpp>
#include <formulations/side_by_side_impl.hpp>
#include <formulations/structured/acceleration_solver_impl.hpp>
#include <mechanism/additions.hpp>
#include <mechanism/mechanism_cast.hpp>
#include <scenes/format/scene_file.hpp>
#include <scenes/make_mechanism.hpp>
#include <simulation/simulate_impl.hpp>

using namespace trivium;

namespace {

/// n(t) . d_ij = 0 with n = cos alpha(t) u_i + sin alpha(t) v_i: the point s_j of body j stays in a plane
/// that turns relative to body i as prescribed. The multiplier is the force [N] of the plane along -n.
template <class Scalar>
struct TurningPlane : BodyPair {
  static constexpr bool is_of_angle = false;

  Vector3<Scalar> u_bar_i, v_bar_i, s_bar_i, s_bar_j;
  TimeFunction alpha;

  static void keys(auto&& show, auto&... c) {
    show.vector_i(c.u_bar_i...);
    show.vector_i(c.v_bar_i...);
    show.point_i(c.s_bar_i...);
    show.point_j(c.s_bar_j...);
    show.need("alpha", c.alpha...);
  }
  const TimeFunction& function() const { return alpha; }
  Scalar scale(const Scalar&) const { return u_bar_i.norm(); }
  template <BodyKinematics Body, class Use>
  auto with_features(const Body& on_i, const Body& on_j, const Scalar& t, const Use& use) const {
    const auto [sine, cosine] = SineCosine<Scalar>(alpha.phase(t));
    const MovingVectorFeature<Body, End::i> n(on_i, cosine.f * u_bar_i + sine.f * v_bar_i,
                                              cosine.f_t * u_bar_i + sine.f_t * v_bar_i,
                                              cosine.f_tt * u_bar_i + sine.f_tt * v_bar_i);
    return use(n, PointOffsetFeature<Body>(on_i, s_bar_i, on_j, s_bar_j), Jet<Scalar>{});
  }
};

/// The force F = -c |v| v at the centre of mass of a body.
template <class Scalar>
struct QuadraticDrag {
  static constexpr std::string_view type = "quadratic_drag";

  std::string name;
  int body = 0;
  Scalar c{0};  ///< drag coefficient [kg/m]

  static void keys(auto&& show, auto&... e) {
    show.body("body", e.body...);
    show.need("c", e.c...);
  }
  void apply(const EffectView<Scalar>& view, std::span<Wrench<Scalar>> wrenches) const {
    const Vector3<Scalar>& v = view.motion[body].r_dot;
    wrenches[body].F -= c * v.norm() * v;
  }
  Scalar power(const EffectView<Scalar>& view) const {
    const Vector3<Scalar>& v = view.motion[body].r_dot;
    return -c * v.norm() * v.squaredNorm();
  }
  Scalar potential_energy(const EffectView<Scalar>&) const { return Scalar(0); }
  Scalar nonconservative_power(const EffectView<Scalar>& view) const { return power(view); }
  bool is_conservative() const { return false; }
};

using Mine = MechanismTypes<StandardConstraints::With<TurningPlane>, StandardEffects::With<QuadraticDrag>>;
using MyFormulations = AllFormulations::WithTypes<Mine>;

/// The mechanism of a scene with drag on every body and one more body, a bead in a plane that turns about z.
Model<double, Mine> with_a_bead(const Model<double>& scene) {
  Model<double, Mine> model{with_more_types<Mine>(scene.mechanism), scene.state};
  auto& m = model.mechanism;
  const int bead = add_body<double, Mine>(model, "bead", {2, Vector3<double>(0.1, 0.2, 0.3).asDiagonal()},
                                          {{0.4, 0, -0.2}, {1, 0, 0, 0}}, {{0, 1, 0}, {0, 0, 0}});
  // n(0) = e_y and the plane turns at 2 rad/s: it carries the bead along, and the bead also moves outwards in
  // the plane
  TurningPlane<double> plane;
  plane.i = m.ground();
  plane.j = bead;
  plane.u_bar_i = Vector3<double>::UnitY();
  plane.v_bar_i = -Vector3<double>::UnitX();
  plane.s_bar_i.setZero();
  plane.s_bar_j = {0.1, 0, 0.2};
  plane.alpha = TimeFunction::Polynomial{{0, 2}};
  add_constraint<double, Mine>(m, "plane", plane);
  for (int b = 0; b < m.nb(); ++b) m.effects.add(QuadraticDrag<double>{"drag", b, 0.3});
  return model;
}

bool both_keep_their_laws(const Model<double, Mine>& model) {
  const auto& m = model.mechanism;
  std::vector<BodyMotion<double>> motion(m.nb() + 1);
  for (int b = 0; b < m.nb(); ++b)
    motion[b] = {model.state.pose[b].r, model.state.twist[b].r_dot, rotation_matrix(model.state.pose[b].p),
                 model.state.twist[b].omega_bar};
  auto broken = broken_laws(m.effects.all<QuadraticDrag<double>>().back(), m.bodies, motion, model.state.t);
  // the laws hold for any motion of the two bodies, so the motion is arbitrary
  const auto& plane = std::get<TurningPlane<double>>(m.rows.back());
  const PlainBody<double> i{{0, 0, 0}, {0.1, -0.2, 0.3}, axis_rotation(0, 0.4), {0.3, 0.7, -0.5}},
      j{{0.5, 0.2, -0.4}, {-0.6, 0.8, 0.1}, axis_rotation(1, 0.9), {-0.2, 0.4, 1.1}};
  for (const BrokenLaw& law : broken_laws(plane, i, j, 0.3)) broken.push_back(law);
  for (const BrokenLaw& law : broken) fmt::print("broken: {}\n", law.text());
  return broken.empty();
}

bool has_the_same_lambda(const Model<double, Mine>& model) {
  const auto all = side_by_side<MyFormulations>(model, analyse_rows(model));
  for (const auto& one : all.formulations)
    if (!one.error.empty()) throw ModelError(one.error);
  const double difference = all.discrepancy().lambda;
  fmt::print("lambda of {} rows in {} formulations differs by {:.1e}; bound {:.1e}; of the plane {:.6f} N\n",
             model.mechanism.nc(), all.formulations.size(), difference, all.lambda_bound(),
             all.formulations[0].solution.lambda[model.mechanism.nc() - 1]);
  return difference <= all.lambda_bound();
}

/// Simulates the model; prints and checks the constraint violation and the energy that the work does not
/// explain.
template <template <class> class F>
bool moves(const Model<double, Mine>& model, const std::string& method, bool projects, Samples& samples) {
  using Typed = typename Retyped<F, Mine>::template In<double>;
  SimulationOptions options;
  options.integrator = method;
  options.end = 0.5;
  options.projects = projects;
  const SimulationReport report = simulate_in<Typed>(model, options, samples);
  fmt::print("{} by {}: Phi {:.1e}, energy unaccounted for {:.1e} J of {:.1e} J of work\n", Typed::name,
             method, report.phi, report.unaccounted_energy, report.work);
  // Limits chosen by experiment. With projection Phi is zero to rounding; without, drift is an integration
  // error.
  return report.phi <= (projects ? 1e-10 : 1e-6) && report.unaccounted_energy <= 1e-5 && report.work != 0;
}

bool agrees(const Model<double, Mine>& model) {
  Samples one, two;
  bool passed = both_keep_their_laws(model) && has_the_same_lambda(model);
  passed = moves<RP>(model, "radau5", true, two) && passed;
  // Without projection, drift beyond the integration error would show that nu or gamma is not a derivative of
  // Phi.
  passed = moves<ROmega>(model, "dopri5", false, one) && passed;
  double apart = 0;
  for (std::size_t b = 0; b < one.all.back().state.pose.size(); ++b)
    raise(apart, (one.all.back().state.pose[b].r - two.all.back().state.pose[b].r).norm());
  fmt::print("r-omega by dopri5 and r-p by radau5 end {:.1e} m apart\n", apart);
  return passed && apart <= 1e-6;  // [m], above the errors of both methods at the default tolerances
}

}  // namespace

int main(int count, char** arguments) {
  bool passed = count > 1;
  for (int k = 1; k < count; ++k)
    passed = agrees(with_a_bead(make_model<double>(scenes::read_scene_file(arguments[k])))) && passed;
  return passed ? 0 : 1;
}
