/// The engine DART, in a separate module. It exchanges Eigen objects with the DART library, which was built
/// for plain x86-64. If the rest of the program is built for the native processor, Eigen aligns its objects
/// differently there, so that no inline function of Eigen may be shared between the two. The module is
/// therefore loaded privately at run time, and exports one function whose signature contains no type of Eigen
/// or DART.

#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/UniversalJoint.hpp>
#include <dart/dynamics/WeldJoint.hpp>

#include "validation/cost/peer_scene.hpp"

namespace trivium::cost {

namespace {

Eigen::Vector3d vector(const Vector3& v) { return {v[0], v[1], v[2]}; }

Eigen::Isometry3d translation(const Vector3& v) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = vector(v);
  return T;
}

Eigen::Isometry3d pose_in_parent(const TreeJoint& branch) {
  const Quaternion& e = branch.orientation;
  Eigen::Isometry3d T = translation(branch.position);
  T.linear() = Eigen::Quaterniond(e[0], e[1], e[2], e[3]).toRotationMatrix();
  return T;
}

dart::dynamics::Inertia inertia_of(const simbody::Body& body) {
  Eigen::Matrix3d J;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      J(r, c) = body.inertia[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
  return dart::dynamics::Inertia(body.mass, Eigen::Vector3d::Zero(), J);
}

class Dart : public Engine {
 public:
  explicit Dart(const PeerScene& scene) : skeleton_(dart::dynamics::Skeleton::create()) {
    skeleton_->setGravity(vector(scene.gravity));
    body_.resize(scene.tree.size());
    for (const TreeJoint& branch : scene.tree) hang(branch, scene);
    Eigen::VectorXd rates = Eigen::VectorXd::Zero(static_cast<int>(skeleton_->getNumDofs()));
    for (const TreeJoint& branch : scene.tree) set_rates(branch, rates);
    skeleton_->setVelocities(rates);
    for (std::size_t b = 0; b < scene.loads.size(); ++b) {
      body_[b]->setExtForce(vector(scene.loads[b].force), Eigen::Vector3d::Zero(), false, true);
      body_[b]->setExtTorque(vector(scene.loads[b].torque), false);
    }
    // DART caches quantities that depend on the positions. Two positions that differ by a negligible 1e-18
    // force it to compute them again in every evaluation.
    for (const double step : {1e-18, 2e-18})
      positions_.push_back(Eigen::VectorXd::Constant(static_cast<int>(skeleton_->getNumDofs()), step));
  }

  void evaluate() override {
    skeleton_->setPositions(positions_[turn_ ^= 1u]);
    skeleton_->computeForwardDynamics();
  }

  std::vector<Vector3> r_ddot() override {
    std::vector<Vector3> r_ddot;
    for (const dart::dynamics::BodyNode* body : body_) {
      const Eigen::Vector3d a = body->getLinearAcceleration();
      r_ddot.push_back({a[0], a[1], a[2]});
    }
    return r_ddot;
  }

 private:
  template <class Joint>
  void add(const TreeJoint& branch, const PeerScene& scene, typename Joint::Properties properties) {
    properties.mT_ChildBodyToJoint = translation(branch.point);
    properties.mT_ParentBodyToJoint = pose_in_parent(branch) * properties.mT_ChildBodyToJoint;
    properties.mName = "j" + std::to_string(branch.body);
    const dart::dynamics::BodyNode::AspectProperties body("b" + std::to_string(branch.body),
                                                          inertia_of(scene.model.bodies[index(branch.body)]));
    dart::dynamics::BodyNode* parent = branch.parent == ground ? nullptr : body_[index(branch.parent)];
    body_[index(branch.body)] = skeleton_
                                    ->createJointAndBodyNodePair<Joint>(
                                        parent, properties, dart::dynamics::BodyNode::Properties(body))
                                    .second;
  }

  void hang(const TreeJoint& branch, const PeerScene& scene) {
    using namespace dart::dynamics;
    const auto& axes = branch.axes;
    if (branch.kind == TreeJoint::Kind::free) return add<FreeJoint>(branch, scene, {});
    if (branch.kind == TreeJoint::Kind::ball) return add<BallJoint>(branch, scene, {});
    if (axes.empty()) return add<WeldJoint>(branch, scene, {});
    if (axes.size() == 1 && axes[0].slides) {
      PrismaticJoint::Properties properties;
      properties.mAxis = vector(axes[0].direction);
      return add<PrismaticJoint>(branch, scene, properties);
    }
    if (axes.size() == 1) {
      RevoluteJoint::Properties properties;
      properties.mAxis = vector(axes[0].direction);
      return add<RevoluteJoint>(branch, scene, properties);
    }
    if (axes.size() == 2 && !axes[0].slides && !axes[1].slides) {
      UniversalJoint::Properties properties;
      properties.mAxis = {{vector(axes[0].direction), vector(axes[1].direction)}};
      return add<UniversalJoint>(branch, scene, properties);
    }
    throw NotTaken("no DART joint is implemented for a joint of the scene");
  }

  void set_rates(const TreeJoint& branch, Eigen::VectorXd& rates) const {
    const dart::dynamics::Joint* joint = body_[index(branch.body)]->getParentJoint();
    const auto place = [&](std::size_t k) -> double& {
      return rates[static_cast<int>(joint->getIndexInSkeleton(k))];
    };
    if (branch.kind != TreeJoint::Kind::axes)
      for (std::size_t k = 0; k < 3; ++k) place(k) = branch.angular_velocity[k];
    if (branch.kind == TreeJoint::Kind::free) {
      const Eigen::Vector3d v = pose_in_parent(branch).linear().transpose() * vector(branch.velocity);
      for (std::size_t k = 0; k < 3; ++k) place(3 + k) = v[static_cast<int>(k)];
    }
    for (std::size_t k = 0; k < branch.axes.size(); ++k) place(k) = branch.axes[k].rate;
  }

  static std::size_t index(int body) { return static_cast<std::size_t>(body); }

  dart::dynamics::SkeletonPtr skeleton_;
  std::vector<dart::dynamics::BodyNode*> body_;
  std::vector<Eigen::VectorXd> positions_;
  unsigned turn_ = 0;
};

}  // namespace

}  // namespace trivium::cost

extern "C" __attribute__((visibility("default"))) trivium::cost::Engine* trivium_make_dart_engine(
    const trivium::cost::PeerScene& scene) {
  if (!scene.closings.empty()) throw trivium::cost::NotTaken("trees only");
  if (scene.tree.size() > 3000) throw trivium::cost::NotTaken("minutes to build its skeleton");
  return new trivium::cost::Dart(scene);
}
