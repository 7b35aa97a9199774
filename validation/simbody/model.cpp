#include "validation/simbody/model.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <memory>

#include "simulation/cpu_time.hpp"
#include "validation/simbody/forces.hpp"

namespace trivium::simbody {

namespace {

using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::Transform;
using SimTK::Vec3;

/// Nothing reaches stderr while this lives: CPodes writes of its troubles there, thousands of lines, whose
/// upshot is an exception or stands in the result.
class SilentErrors {
 public:
  SilentErrors() : kept_(::dup(STDERR_FILENO)) {
    std::fflush(stderr);
    const int nowhere = ::open("/dev/null", O_WRONLY);
    if (kept_ >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) ::close(nowhere);
  }
  ~SilentErrors() {
    std::fflush(stderr);
    if (kept_ < 0) return;
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
  }
  SilentErrors(const SilentErrors&) = delete;
  SilentErrors& operator=(const SilentErrors&) = delete;

 private:
  int kept_;
};

/// A model rebuilt in Simbody, at its state.
class System {
 public:
  System(const Model& model, Way way)
      : model_(model), matter_(system_), forces_(system_), bodies_{matter_, {}} {
    matter_.setShowDefaultGeometry(false);
    tree_ = spanning_tree(model, way == Way::mobilizers);
    bodies_.index.resize(model.bodies.size());
    branch_of_joint_.assign(model.joints.size(), nullptr);
    for (const Branch& branch : tree_) {
      bodies_.index[static_cast<std::size_t>(branch.body)] = add_mobilizer(model, branch, bodies_);
      if (branch.joint != Branch::none) branch_of_joint_[static_cast<std::size_t>(branch.joint)] = &branch;
    }
    for (std::size_t k = 0; k < model.joints.size(); ++k) {
      if (branch_of_joint_[k]) continue;
      const auto add = way == Way::built_in ? add_built_in_rows : add_custom_rows;
      add(model, static_cast<int>(k), bodies_, constraints_);
    }
    add_effects(model, tree_, bodies_, forces_);
    state_ = system_.realizeTopology();
    system_.realizeModel(state_);
    state_.updTime() = model.t;
    for (const Branch& branch : tree_) fit_mobilizer(model, branch, bodies_, state_);
    if (way == Way::mobilizers) disable_idle_rows();
    system_.realize(state_, SimTK::Stage::Acceleration);
  }

  Motion move(Integrator which, double accuracy, const std::vector<double>& times) {
    const std::unique_ptr<SimTK::Integrator> integrator = make(which);
    integrator->setAccuracy(accuracy);
    integrator->setConstraintTolerance(accuracy);
    // CPodes' own polynomial is as exact as its steps; that of the Runge-Kutta methods is a cubic
    const bool interpolates = which == Integrator::cpodes_adams || which == Integrator::cpodes_bdf;
    integrator->setAllowInterpolation(interpolates);
    Motion out;
    const SilentErrors silent;
    const double start = cpu_seconds();
    integrator->initialize(state_);
    for (const double t : times) {
      while (integrator->getTime() < t) integrator->stepTo(t, interpolates ? SimTK::Infinity : t);
      state_ = integrator->getState();
      read_states(out);
    }
    out.seconds = cpu_seconds() - start;
    out.steps = integrator->getNumStepsTaken();
    out.realizations = integrator->getNumRealizations();
    return out;
  }

  Answer answer() const {
    Answer out;
    read_bodies(out);
    read_multipliers(out);
    read_reactions(out);
    out.jacobian_defect = jacobian_defect();
    for (const Branch* branch : branch_of_joint_) out.mobilizers += branch ? 1 : 0;
    for (const LinkedConstraint& c : constraints_) out.constraint_rows += static_cast<int>(c.rows.size());
    out.idle_rows = static_cast<int>(idle_rows_.size());
    return out;
  }

 private:
  std::unique_ptr<SimTK::Integrator> make(Integrator which) const {
    switch (which) {
      case Integrator::explicit_euler:
        return std::make_unique<SimTK::ExplicitEulerIntegrator>(system_);
      case Integrator::semi_explicit_euler_2:
        return std::make_unique<SimTK::SemiExplicitEuler2Integrator>(system_);
      case Integrator::verlet:
        return std::make_unique<SimTK::VerletIntegrator>(system_);
      case Integrator::runge_kutta_2:
        return std::make_unique<SimTK::RungeKutta2Integrator>(system_);
      case Integrator::runge_kutta_3:
        return std::make_unique<SimTK::RungeKutta3Integrator>(system_);
      case Integrator::runge_kutta_merson:
        return std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system_);
      case Integrator::runge_kutta_feldberg:
        return std::make_unique<SimTK::RungeKuttaFeldbergIntegrator>(system_);
      case Integrator::cpodes_adams:
        return std::make_unique<SimTK::CPodesIntegrator>(system_, SimTK::CPodes::Adams);
      default:
        return std::make_unique<SimTK::CPodesIntegrator>(system_, SimTK::CPodes::BDF);
    }
  }

  void read_states(Motion& out) const {
    system_.realize(state_, SimTK::Stage::Velocity);
    std::vector<BodyState> states;
    for (int b = 0; b < static_cast<int>(model_.bodies.size()); ++b) {
      const MobilizedBody& body = bodies_[b];
      const Rotation& R = body.getBodyRotation(state_);
      const SimTK::Quaternion q = R.convertRotationToQuaternion();
      const SpatialVec& V = body.getBodyVelocity(state_);
      states.push_back({array(body.getBodyOriginLocation(state_)),
                        {q[0], q[1], q[2], q[3]},
                        array(V[1]),
                        array(~R * V[0])});
    }
    out.states.push_back(states);
  }

  Vec3 point_on_i(const Joint& joint) const {
    return bodies_[joint.i].findStationLocationInGround(state_, vec(joint.frame_i.point));
  }

  void disable_idle_rows() {
    system_.realize(state_, SimTK::Stage::Velocity);
    std::vector<LinkedConstraint> active, idle;
    for (const LinkedConstraint& c : constraints_)
      (is_idle(matter_, matter_.getConstraint(c.index), state_) ? idle : active).push_back(c);
    for (const LinkedConstraint& c : idle) {
      matter_.getConstraint(c.index).disable(state_);
      idle_rows_.push_back(c.rows.front().row);
    }
    constraints_ = active;
  }

  /// Simbody forms G^T from the forces of its constraints and G from their errors: they must be the same.
  double jacobian_defect() const {
    if (constraints_.empty()) return 0;
    SimTK::Matrix G, G_transposed;
    matter_.calcG(state_, G);
    matter_.calcGTranspose(state_, G_transposed);
    double defect = 0;
    for (int row = 0; row < G.nrow(); ++row)
      for (int u = 0; u < G.ncol(); ++u)
        defect = std::max(defect, std::abs(G(row, u) - G_transposed(u, row)));
    return defect;
  }

  void read_bodies(Answer& out) const {
    for (int b = 0; b < static_cast<int>(model_.bodies.size()); ++b) {
      const MobilizedBody& body = bodies_[b];
      const SpatialVec& A = body.getBodyAcceleration(state_);
      out.r_ddot.push_back(array(A[1]));
      out.omega_bar_dot.push_back(array(~body.getBodyRotation(state_) * A[0]));
      const Transform X = pose_of(model_, b);
      const SpatialVec V = velocity_of(model_, b), dV = body.getBodyVelocity(state_) - V;
      const Rotation dR = ~X.R() * body.getBodyRotation(state_);
      out.pose_defect = std::max({out.pose_defect, (body.getBodyOriginLocation(state_) - X.p()).norm(),
                                  std::abs(dR.convertRotationToAngleAxis()[0]), dV[0].norm(), dV[1].norm()});
    }
  }

  void read_multipliers(Answer& out) const {
    out.lambda.assign(model_.rows.size(), 0.0);
    out.lambda_known.assign(model_.rows.size(), false);
    for (const int row : idle_rows_) out.lambda_known[static_cast<std::size_t>(row)] = true;
    for (const LinkedConstraint& c : constraints_) {
      const SimTK::Vector multipliers = matter_.getConstraint(c.index).getMultipliersAsVector(state_);
      for (std::size_t k = 0; k < c.rows.size(); ++k) {
        const std::size_t row = static_cast<std::size_t>(c.rows[k].row);
        out.lambda[row] = c.rows[k].scale * multipliers[static_cast<int>(k)];
        out.lambda_known[row] = true;
      }
    }
  }

  void read_reactions(Answer& out) const {
    std::vector<SpatialVec> on_i(model_.joints.size(), SpatialVec(Vec3(0), Vec3(0))), on_j = on_i;
    SimTK::Vector_<SpatialVec> on_child;
    matter_.calcMobilizerReactionForces(state_, on_child);
    for (std::size_t k = 0; k < on_j.size(); ++k) {
      if (!branch_of_joint_[k]) continue;
      on_j[k] = mobilizer_reaction(model_.joints[k], *branch_of_joint_[k], on_child);
      on_i[k] = SpatialVec(-on_j[k][0], -on_j[k][1]);
    }
    for (const LinkedConstraint& c : constraints_) {
      const std::size_t k = static_cast<std::size_t>(c.joint);
      const SimTK::Constraint& constraint = matter_.getConstraint(c.index);
      on_i[k] += constraint_reaction(model_.joints[k], model_.joints[k].i, constraint);
      on_j[k] += constraint_reaction(model_.joints[k], model_.joints[k].j, constraint);
    }
    for (std::size_t k = 0; k < on_j.size(); ++k) {
      const Vector3 point = array(point_on_i(model_.joints[k]));
      out.reactions_on_i.push_back({array(on_i[k][1]), array(on_i[k][0]), point});
      out.reactions_on_j.push_back({array(on_j[k][1]), array(on_j[k][0]), point});
    }
  }

  /// From the child at M to body j at the joint's point on i.
  SpatialVec mobilizer_reaction(const Joint& joint, const Branch& branch,
                                const SimTK::Vector_<SpatialVec>& on_child) const {
    const MobilizedBody& child = bodies_[branch.body];
    const SpatialVec& at_M = on_child[child.getMobilizedBodyIndex()];
    const Vec3 M = child.findStationLocationInGround(state_, child.getOutboardFrame(state_).p());
    const SpatialVec moved(at_M[0] + (M - point_on_i(joint)) % at_M[1], at_M[1]);
    return branch.reversed ? SpatialVec(-moved[0], -moved[1]) : moved;
  }

  /// -G^T lambda on a body of the joint, which Simbody gives at the body's origin, at the joint's point on i.
  SpatialVec constraint_reaction(const Joint& joint, int body, const SimTK::Constraint& constraint) const {
    SimTK::Vector_<SpatialVec> applied;
    SimTK::Vector mobility_forces;
    constraint.calcConstraintForcesFromMultipliers(state_, constraint.getMultipliersAsVector(state_), applied,
                                                   mobility_forces);
    const MobilizedBody& end = bodies_[body];
    const Vec3 arm = end.getBodyOriginLocation(state_) - point_on_i(joint);
    SpatialVec sum(Vec3(0), Vec3(0));
    for (SimTK::ConstrainedBodyIndex b(0); b < constraint.getNumConstrainedBodies(); ++b)
      if (constraint.getMobilizedBodyFromConstrainedBody(b).getMobilizedBodyIndex() ==
          end.getMobilizedBodyIndex())
        sum -= SpatialVec(applied[b][0] + arm % applied[b][1], applied[b][1]);
    return sum;
  }

  const Model& model_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  BodyMap bodies_;
  std::vector<Branch> tree_;
  std::vector<const Branch*> branch_of_joint_;  ///< where the joint became a mobilizer
  std::vector<LinkedConstraint> constraints_;
  std::vector<int> idle_rows_;
  SimTK::State state_;
};

/// Simbody's messages run over lines and begin with the place in its source.
std::string on_one_line(const std::string& message) {
  std::string line;
  for (const char c : message) {
    const char printable = std::isspace(static_cast<unsigned char>(c)) ? ' ' : c;
    if (printable != ' ' || (!line.empty() && line.back() != ' ')) line += printable;
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  const std::string prefix = "SimTK Exception thrown at ";
  const std::size_t end = line.rfind(prefix, 0) == 0 ? line.find(": ") : std::string::npos;
  return end == std::string::npos ? line : line.substr(end + 2);
}

bool is_finite(const Vector3& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

bool is_finite(const Answer& answer) {
  const auto finite = [](const auto& v) { return is_finite(v); };
  const auto finite_reaction = [](const Reaction& r) { return is_finite(r.force) && is_finite(r.torque); };
  return std::all_of(answer.r_ddot.begin(), answer.r_ddot.end(), finite) &&
         std::all_of(answer.omega_bar_dot.begin(), answer.omega_bar_dot.end(), finite) &&
         std::all_of(answer.lambda.begin(), answer.lambda.end(), [](double x) { return std::isfinite(x); }) &&
         std::all_of(answer.reactions_on_i.begin(), answer.reactions_on_i.end(), finite_reaction) &&
         std::all_of(answer.reactions_on_j.begin(), answer.reactions_on_j.end(), finite_reaction);
}

}  // namespace

std::vector<int> mobilizers(const Model& model, Way way) {
  std::vector<int> joints;
  for (const Branch& branch : spanning_tree(model, way == Way::mobilizers))
    if (branch.joint != Branch::none) joints.push_back(branch.joint);
  return joints;
}

Motion move(const Model& model, Way way, Integrator integrator, double accuracy,
            const std::vector<double>& times) {
  try {
    return System(model, way).move(integrator, accuracy, times);
  } catch (const Refused&) {
    throw;
  } catch (const std::exception& error) {
    throw Refused(on_one_line(error.what()));
  }
}

Answer solve(const Model& model, Way way) {
  Answer answer;
  try {
    answer = System(model, way).answer();
  } catch (const Refused&) {
    throw;
  } catch (const std::exception& error) {
    throw Refused(on_one_line(error.what()));
  }
  if (!is_finite(answer)) throw Refused("Simbody's accelerations or multipliers are not finite");
  return answer;
}

}  // namespace trivium::simbody
