/// Translates functions of time, joints, rows and effects type by type. A type that the Simbody model does
/// not have is an error.

#include "validation/simbody/translation.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium {

namespace {

simbody::Vector3 plain(const Vector3<double>& v) { return {v[0], v[1], v[2]}; }

simbody::TimeFunction plain(const TimeFunction& f) {
  const auto value = [f](double t) {
    const Jet<double> jet = f(t);
    return simbody::Vector3{jet.f, jet.f_t, jet.f_tt};
  };
  return {value, f.is_number()};
}

std::array<simbody::TimeFunction, 3> plain(const std::array<TimeFunction, 3>& f) {
  return {plain(f[0]), plain(f[1]), plain(f[2])};
}

simbody::JointFrame plain(const JointFrame<double>& f) {
  return {plain(f.point), plain(f.u), plain(f.v), plain(f.z)};
}

/// Replaces the index nb, which is the ground in a mechanism, by simbody::ground.
simbody::BodyPair plain(const BodyPair& pair, int nb) {
  const auto index = [nb](int body) { return body == nb ? simbody::ground : body; };
  return {index(pair.i), index(pair.j)};
}

simbody::JointType plain(ConstraintType type) {
  switch (type.joint) {
    case JointType::revolute:
      return simbody::JointType::revolute;
    case JointType::universal:
      return simbody::JointType::universal;
    case JointType::spherical:
      return simbody::JointType::spherical;
    case JointType::cylindrical:
      return simbody::JointType::cylindrical;
    case JointType::translational:
      return simbody::JointType::translational;
    case JointType::planar:
      return simbody::JointType::planar;
    case JointType::fixed:
      return simbody::JointType::fixed;
    case JointType::basic:
    case JointType::in_line:
    case JointType::in_plane:
    case JointType::distance:
    case JointType::rotation_driver:
      return simbody::JointType::other;
  }
  return simbody::JointType::other;
}

struct RowTranslation {
  simbody::Row operator()(const DP1<double>& c) const {
    simbody::Row row;
    row.type = simbody::RowType::dp1;
    row.a_i = plain(c.a_bar_i);
    row.a_j = plain(c.a_bar_j);
    row.f = plain(c.f);
    return row;
  }
  simbody::Row operator()(const TurningDP1<double>& c) const {
    simbody::Row row;
    row.type = simbody::RowType::turning_dp1;
    row.a_i = plain(c.u_bar_i);
    row.v_i = plain(c.v_bar_i);
    row.a_j = plain(c.a_bar_j);
    row.f = plain(c.alpha);
    return row;
  }
  simbody::Row operator()(const DP2<double>& c) const {
    simbody::Row row = points(simbody::RowType::dp2, c);
    row.a_i = plain(c.a_bar_i);
    return row;
  }
  simbody::Row operator()(const D<double>& c) const { return points(simbody::RowType::d, c); }
  simbody::Row operator()(const CD<double>& c) const {
    simbody::Row row = points(simbody::RowType::cd, c);
    row.a_i = plain(c.c);
    return row;
  }

  /// A type of row that the Simbody model does not have.
  template <class Other>
  simbody::Row operator()(const Other&) const {
    std::string kind = "basic constraint of this type";
    if constexpr (requires { Other::type; }) kind = Other::type;
    throw ModelError(fmt::format("Simbody's model has no {}; leave the scene out of the comparison", kind));
  }

  template <class Constraint>
  static simbody::Row points(simbody::RowType type, const Constraint& c) {
    simbody::Row row;
    row.type = type;
    row.s_i = plain(c.s_bar_i);
    row.s_j = plain(c.s_bar_j);
    row.f = plain(c.f);
    return row;
  }
};

struct EffectTranslation {
  simbody::Model& model;

  void operator()(const Gravity<double>& e) const { model.gravity.push_back(plain(e.acceleration)); }
  void operator()(const Force<double>& e) const {
    model.forces.push_back({e.body, plain(e.s_bar), plain(e.components), e.frame == ComponentFrame::body});
  }
  void operator()(const Torque<double>& e) const {
    model.torques.push_back({e.body, plain(e.components), e.frame == ComponentFrame::body});
  }
  void operator()(const SpringDamper<double>& e) const {
    simbody::SpringDamper spring;
    spring.i = e.i.body;
    spring.j = e.j.body;
    spring.point_i = plain(e.i.s_bar);
    spring.point_j = plain(e.j.s_bar);
    spring.stiffness = e.stiffness;
    spring.damping = e.damping;
    spring.free_length = e.free_length;
    spring.actuator = plain(e.actuator);
    model.springs.push_back(spring);
  }
  /// The angle in Simbody starts in (-pi, pi]. The initial whole turns, which `tracked` holds, are therefore
  /// subtracted from the free angle.
  void operator()(const TorsionalSpringDamper<double>& e) const {
    model.torsional_springs.push_back(
        {e.angle.joint, e.stiffness, e.damping, e.free_angle - e.angle.tracked, plain(e.actuator)});
  }
  /// A type of effect that the Simbody model does not have.
  template <class Other>
  void operator()(const Other&) const {
    throw ModelError(
        fmt::format("Simbody's model has no {}; leave the scene out of the comparison", Other::type));
  }
};

static_assert(scenes::ground == simbody::ground);

}  // namespace

simbody::Model to_simbody(const scenes::Scene& scene, double t) {
  return to_simbody(scene, make_model<double>(scene, t));
}

simbody::Model to_simbody(const scenes::Scene& scene, const Model<double>& made) {
  const auto& [mechanism, state] = made;
  const int nb = mechanism.nb();
  simbody::Model model;
  model.t = state.t;
  for (int b = 0; b < nb; ++b) {
    const Matrix3<double>& J = mechanism.bodies[b].inertia;
    const Vector4<double>& p = state.pose[b].p;
    model.bodies.push_back({mechanism.body_names[b],
                            mechanism.bodies[b].mass,
                            {plain(Vector3<double>(J.row(0))), plain(Vector3<double>(J.row(1))),
                             plain(Vector3<double>(J.row(2)))},
                            plain(state.pose[b].r),
                            {p[0], p[1], p[2], p[3]},
                            plain(state.twist[b].r_dot),
                            plain(state.twist[b].omega_bar)});
  }
  for (const auto& constraint : mechanism.rows) {
    simbody::Row row = std::visit(RowTranslation{}, constraint);
    static_cast<simbody::BodyPair&>(row) = plain(bodies_of(constraint), nb);
    model.rows.push_back(row);
  }
  for (const Joint<double>& joint : mechanism.joints) {
    simbody::Joint out;
    static_cast<simbody::BodyPair&>(out) = plain(joint, nb);
    out.name = joint.name;
    out.type = plain(joint.type);
    out.frame_i = plain(joint.frame_i);
    out.frame_j = plain(joint.frame_j);
    out.first_row = joint.first_row;
    out.rows = joint.rows;
    model.joints.push_back(out);
  }
  for (const scenes::Effect& effect : scene.effects) std::visit(EffectTranslation{model}, effect);
  return model;
}

}  // namespace trivium
