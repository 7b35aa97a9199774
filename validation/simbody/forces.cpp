/// Makes a force of Simbody for every effect. Angles of torsional springs are taken from the mobilizer if the
/// joint is a pin or a cylinder, else from the orientations of both bodies.

#include "validation/simbody/forces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trivium::simbody {

namespace {

using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::State;
using SimTK::Vec3;
using BodyForces = SimTK::Vector_<SimTK::SpatialVec>;

/// A Simbody force that a function of the state applies.
class ForceFromState : public SimTK::Force::Custom::Implementation {
 public:
  using Apply = std::function<void(const State&, BodyForces&)>;
  explicit ForceFromState(Apply apply) : apply_(std::move(apply)) {}

  void calcForce(const State& state, BodyForces& body_forces, SimTK::Vector_<Vec3>&,
                 SimTK::Vector&) const override {
    apply_(state, body_forces);
  }
  double calcPotentialEnergy(const State&) const override { return 0; }

 private:
  Apply apply_;
};

using Components = std::array<TimeFunction, 3>;

Vec3 evaluate(const Components& f, double t) {
  return {f[0].value(t)[0], f[1].value(t)[0], f[2].value(t)[0]};
}

bool is_constant(const Components& f) { return f[0].is_number && f[1].is_number && f[2].is_number; }

/// The angle from u_i to u_j about z_i, its rate, and z_i in Ground components.
struct Twist {
  double angle, rate;
  Vec3 axis;
};

/// The angle of a pin or cylinder from its coordinate. A reversed mobilizer measures the motion of i relative
/// to j, so that the sign changes.
Twist twist_of_mobilizer(const State& state, const MobilizedBody& child, bool reversed, const Vec3& z_i,
                         const MobilizedBody& i) {
  const double sign = reversed ? -1 : 1;
  return {sign * child.getOneQ(state, 0), sign * child.getOneU(state, 0),
          i.expressVectorInGroundFrame(state, z_i)};
}

Twist twist_of_bodies(const State& state, const Joint& joint, const MobilizedBody& i,
                      const MobilizedBody& j) {
  const auto axes = [](const JointFrame& f) {
    return Rotation(SimTK::Mat33(vec(f.u), vec(f.v), vec(f.z)), true);
  };
  const Rotation R_i = i.getBodyRotation(state) * axes(joint.frame_i);
  const Rotation R_ij = ~R_i * (j.getBodyRotation(state) * axes(joint.frame_j));
  const Vec3 z = R_i * Vec3(0, 0, 1);
  const Vec3 w = j.getBodyAngularVelocity(state) - i.getBodyAngularVelocity(state);
  return {std::atan2(R_ij[1][0], R_ij[0][0]), SimTK::dot(w, z), z};
}

class EffectBuilder {
 public:
  EffectBuilder(const Model& model, const std::vector<Branch>& tree, const BodyMap& bodies,
                SimTK::GeneralForceSubsystem& forces)
      : model_(model), tree_(tree), bodies_(bodies), forces_(forces) {}

  void add(const Vector3& gravity) { SimTK::Force::Gravity(forces_, bodies_.matter, vec(gravity)); }

  void add(const Force& e) {
    const MobilizedBody body = bodies_[e.body];
    const Vec3 point = vec(e.point);
    if (!e.in_body_frame && is_constant(e.components)) {
      SimTK::Force::ConstantForce(forces_, body, point, evaluate(e.components, model_.t));
      return;
    }
    custom([body, point, e](const State& state, BodyForces& out) {
      const Vec3 F = evaluate(e.components, state.getTime());
      body.applyForceToBodyPoint(state, point, e.in_body_frame ? body.getBodyRotation(state) * F : F, out);
    });
  }

  void add(const Torque& e) {
    const MobilizedBody body = bodies_[e.body];
    if (!e.in_body_frame && is_constant(e.components)) {
      SimTK::Force::ConstantTorque(forces_, body, evaluate(e.components, model_.t));
      return;
    }
    custom([body, e](const State& state, BodyForces& out) {
      const Vec3 n = evaluate(e.components, state.getTime());
      body.applyBodyTorque(state, e.in_body_frame ? body.getBodyRotation(state) * n : n, out);
    });
  }

  void add(const SpringDamper& e) {
    const MobilizedBody i = bodies_[e.i], j = bodies_[e.j];
    const Vec3 p = vec(e.point_i), q = vec(e.point_j);
    if (e.stiffness != 0) SimTK::Force::TwoPointLinearSpring(forces_, i, p, j, q, e.stiffness, e.free_length);
    if (e.damping != 0) SimTK::Force::TwoPointLinearDamper(forces_, i, p, j, q, e.damping);
    if (e.actuator.is_number && e.actuator.value(model_.t)[0] == 0) return;
    custom([i, j, p, q, h = e.actuator](const State& state, BodyForces& out) {
      const SimTK::UnitVec3 towards_j(j.findStationLocationInGround(state, q) -
                                      i.findStationLocationInGround(state, p));
      const Vec3 pull = h.value(state.getTime())[0] * towards_j;
      i.applyForceToBodyPoint(state, p, pull, out);
      j.applyForceToBodyPoint(state, q, -pull, out);
    });
  }

  void add(const TorsionalSpringDamper& e) {
    const Joint& joint = model_.joints[static_cast<std::size_t>(e.joint)];
    const MobilizedBody i = bodies_[joint.i], j = bodies_[joint.j];
    const auto branch =
        std::find_if(tree_.begin(), tree_.end(), [&](const Branch& b) { return b.joint == e.joint; });
    std::function<Twist(const State&)> measure = [joint, i, j](const State& state) {
      return twist_of_bodies(state, joint, i, j);
    };
    if (branch != tree_.end())
      measure = [child = bodies_[branch->body], reversed = branch->reversed, z = vec(joint.frame_i.z),
                 i](const State& state) { return twist_of_mobilizer(state, child, reversed, z, i); };
    custom([measure, i, j, e](const State& state, BodyForces& out) {
      const Twist twist = measure(state);
      const double torque = -(e.stiffness * (twist.angle - e.free_angle) + e.damping * twist.rate +
                              e.actuator.value(state.getTime())[0]);
      j.applyBodyTorque(state, torque * twist.axis, out);
      i.applyBodyTorque(state, -torque * twist.axis, out);
    });
  }

 private:
  void custom(ForceFromState::Apply apply) {
    SimTK::Force::Custom(forces_, new ForceFromState(std::move(apply)));
  }

  const Model& model_;
  const std::vector<Branch>& tree_;
  const BodyMap& bodies_;
  SimTK::GeneralForceSubsystem& forces_;
};

}  // namespace

void add_effects(const Model& model, const std::vector<Branch>& tree, const BodyMap& bodies,
                 SimTK::GeneralForceSubsystem& forces) {
  EffectBuilder builder(model, tree, bodies, forces);
  for (const Vector3& e : model.gravity) builder.add(e);
  for (const Force& e : model.forces) builder.add(e);
  for (const Torque& e : model.torques) builder.add(e);
  for (const SpringDamper& e : model.springs) builder.add(e);
  for (const TorsionalSpringDamper& e : model.torsional_springs) builder.add(e);
}

}  // namespace trivium::simbody
