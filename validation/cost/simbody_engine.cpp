/// Simbody as an engine of the measurements of cost.

#include "validation/cost/peers.hpp"
#include "validation/simbody/forces.hpp"

namespace trivium::cost {

namespace {

class Simbody : public Engine {
 public:
  explicit Simbody(const PeerScene& scene) : matter_(system_), forces_(system_), bodies_{matter_, {}} {
    const simbody::Model& model = scene.model;
    matter_.setShowDefaultGeometry(false);
    std::vector<simbody::Branch> tree;
    for (const TreeJoint& b : scene.tree) tree.push_back({b.body, b.parent, b.joint, b.reversed});
    bodies_.index.resize(model.bodies.size());
    for (const simbody::Branch& branch : tree)
      bodies_.index[static_cast<std::size_t>(branch.body)] = add_mobilizer(model, branch, bodies_);
    std::vector<simbody::LinkedConstraint> constraints;
    for (const int joint : scene.closings) add_built_in_rows(model, joint, bodies_, constraints);
    add_effects(model, tree, bodies_, forces_);
    state_ = system_.realizeTopology();
    system_.realizeModel(state_);
    for (const simbody::Branch& branch : tree) fit_mobilizer(model, branch, bodies_, state_);
    system_.realize(state_, SimTK::Stage::Velocity);
    disable_idle(constraints);
  }

  void evaluate() override {
    state_.updQ();  // invalidates Stage::Position, so that all is computed again
    system_.realize(state_, SimTK::Stage::Acceleration);
  }

  std::vector<Vector3> r_ddot() override {
    std::vector<Vector3> r_ddot;
    for (int b = 0; b < static_cast<int>(bodies_.index.size()); ++b)
      r_ddot.push_back(simbody::array(bodies_[b].getBodyAcceleration(state_)[1]));
    return r_ddot;
  }

 private:
  void disable_idle(const std::vector<simbody::LinkedConstraint>& constraints) {
    std::vector<SimTK::ConstraintIndex> idle;
    for (const simbody::LinkedConstraint& c : constraints)
      if (c.rows.size() == 1 && simbody::is_idle(matter_, matter_.getConstraint(c.index), state_))
        idle.push_back(c.index);
    for (const SimTK::ConstraintIndex index : idle) matter_.getConstraint(index).disable(state_);
  }

  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  simbody::BodyMap bodies_;
  SimTK::State state_;
};

/// Simbody factors a dense matrix of all closing rows; with more closing joints an evaluation takes seconds.
constexpr std::size_t most_closings = 150;

}  // namespace

std::unique_ptr<Engine> simbody_engine(const PeerScene& scene) {
  if (scene.closings.size() > most_closings)
    throw NotTaken("its matrix of the closing rows is dense: seconds an evaluation");
  return std::make_unique<Simbody>(scene);
}

}  // namespace trivium::cost
