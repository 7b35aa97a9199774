#include "validation/simbody/comparison.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>

#include "bodies/inertia.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/so3.hpp"
#include "scenes/make_mechanism.hpp"
#include "validation/simbody/massless_motion.hpp"
#include "validation/simbody/physical_inertia.hpp"
#include "validation/simbody/translation.hpp"

namespace trivium {

namespace {

using Vector6 = Vector<double, 6>;

Vector3<double> eigen(const simbody::Vector3& v) { return {v[0], v[1], v[2]}; }

/// A joint's reaction on either body; see simbody::Answer.
struct JointReaction {
  Reaction<double> on_i, on_j;
};

/// What both sides' reactions are turned into for comparison.
class ReactionFrame {
 public:
  ReactionFrame(const scenes::Scene& scene, double t, const RowAnalysis& rows)
      : mechanism_(make_mechanism<double>(scene)), state_(make_state<double>(scene, t)), rows_(rows) {
    Phi_ = tangent_system(mechanism_, state_).Phi;
  }

  const Mechanism<double>& mechanism() const { return mechanism_; }
  const MatrixX<double>& Phi() const { return Phi_; }

  /// The metric wrenches of all unique joint reactions, then those of all joints together on every body.
  VectorX<double> stack(const std::vector<JointReaction>& reactions) const {
    VectorX<double> out = VectorX<double>::Zero(6 * (mechanism_.nb() + unique_joints()));
    Eigen::Index next = 6 * mechanism_.nb();
    for (std::size_t k = 0; k < reactions.size(); ++k) {
      const Joint<double>& joint = mechanism_.joints[k];
      if (joint.j != mechanism_.ground())
        out.segment<6>(6 * joint.j) += metric_wrench(joint.j, reactions[k].on_j);
      if (joint.i != mechanism_.ground())
        out.segment<6>(6 * joint.i) += metric_wrench(joint.i, reactions[k].on_i);
      if (!is_unique(joint)) continue;
      out.segment<6>(next) = metric_wrench(joint, reactions[k]);
      next += 6;
    }
    return out;
  }

  /// A formulation's reactions: on body j as it gives them, on body i from the rows' gradients there.
  std::vector<JointReaction> reactions(const FormulationResult<double>& result) const {
    std::vector<JointReaction> out;
    for (std::size_t k = 0; k < mechanism_.joints.size(); ++k)
      out.push_back({reaction_on_i(mechanism_.joints[k], result.solution.lambda), result.reactions[k]});
    return out;
  }

  /// The lambda of a joint's own rows (independent among themselves) that its reaction stands for.
  VectorX<double> multipliers(const Joint<double>& joint, const JointReaction& reaction) const {
    const int body = body_of(joint);
    MatrixX<double> B = Phi_.block(joint.first_row, 6 * body, joint.rows, 6).transpose();
    B = rows_.acceleration_scale.segment<6>(6 * body).cwiseInverse().asDiagonal() * B;
    return -B.colPivHouseholderQr().solve(metric_wrench(joint, reaction));
  }

 private:
  int body_of(const Joint<double>& joint) const { return joint.j != mechanism_.ground() ? joint.j : joint.i; }

  /// -Phi^T lambda on body i; nothing on the ground.
  Reaction<double> reaction_on_i(const Joint<double>& joint, const VectorX<double>& lambda) const {
    if (joint.i == mechanism_.ground()) return {};
    const Pose<double>& pose = state_.pose[static_cast<std::size_t>(joint.i)];
    const Vector6 wrench = -Phi_.block(joint.first_row, 6 * joint.i, joint.rows, 6).transpose() *
                           lambda.segment(joint.first_row, joint.rows);
    return {wrench.head<3>(), rotation_matrix(pose.p) * wrench.tail<3>(), pose.r};
  }

  Vector6 metric_wrench(const Joint<double>& joint, const JointReaction& reaction) const {
    const int body = body_of(joint);
    return metric_wrench(body, body == joint.j ? reaction.on_j : reaction.on_i);
  }

  /// Force over sqrt(m) and torque about the centre of mass, body frame, over sqrt(J).
  Vector6 metric_wrench(int body, const Reaction<double>& reaction) const {
    const Pose<double>& pose = state_.pose[static_cast<std::size_t>(body)];
    const Reaction<double> moved = reaction.about(pose.r);
    Vector6 wrench;
    wrench << moved.force, rotation_matrix(pose.p).transpose() * moved.torque;
    return wrench.cwiseQuotient(rows_.acceleration_scale.segment<6>(6 * body));
  }

  /// No combination of rows that vanishes has a wrench at this joint.
  bool is_unique(const Joint<double>& joint) const {
    if (rows_.redundant.empty()) return true;
    const MatrixX<double> wrench = Phi_.middleRows(joint.first_row, joint.rows).transpose() *
                                   rows_.null_basis.middleRows(joint.first_row, joint.rows);
    const MatrixX<double> scaled = rows_.acceleration_scale.cwiseInverse().asDiagonal() * wrench;
    return scaled.norm() <= rank_tolerance;
  }
  int unique_joints() const {
    return static_cast<int>(std::count_if(mechanism_.joints.begin(), mechanism_.joints.end(),
                                          [this](const Joint<double>& j) { return is_unique(j); }));
  }

  Mechanism<double> mechanism_;
  MechanismState<double> state_;
  const RowAnalysis& rows_;
  MatrixX<double> Phi_;
};

Reaction<double> eigen(const simbody::Reaction& r) {
  return {eigen(r.force), eigen(r.torque), eigen(r.point)};
}

/// Simbody's answer in our terms.
struct SimbodySolution {
  PhysicalSolution<double> solution;
  std::vector<JointReaction> reactions;
};

/// Where a joint became a mobilizer its lambda is the one that its reaction stands for.
SimbodySolution to_trivium_solution(const simbody::Model& model, const simbody::Answer& answer,
                                    const ReactionFrame& frame) {
  SimbodySolution out;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    out.solution.r_ddot.push_back(eigen(answer.r_ddot[b]));
    out.solution.omega_bar_dot.push_back(eigen(answer.omega_bar_dot[b]));
  }
  out.solution.lambda = Eigen::Map<const VectorX<double>>(answer.lambda.data(), frame.mechanism().nc());
  const Mechanism<double>& mechanism = frame.mechanism();
  for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
    const Joint<double>& joint = mechanism.joints[k];
    const JointReaction reaction{eigen(answer.reactions_on_i[k]), eigen(answer.reactions_on_j[k])};
    if (!answer.lambda_known[static_cast<std::size_t>(joint.first_row)])
      out.solution.lambda.segment(joint.first_row, joint.rows) = frame.multipliers(joint, reaction);
    out.reactions.push_back(reaction);
  }
  return out;
}

double relative_distance(const VectorX<double>& a, const VectorX<double>& b, double cause) {
  const double difference = (a - b).norm();
  return difference == 0 ? 0.0 : difference / std::max({a.norm(), b.norm(), cause});
}

/// Everything that one scene's comparisons share.
struct Subject {
  Subject(const scenes::Scene& scene, double t)
      : model(to_simbody(scene, t)), side(solve(scene, t)), frame(scene, t, side.rows) {}
  static SideBySide<double> solve(const scenes::Scene& scene, double t) {
    const auto model = make_model<double>(scene, t);
    return side_by_side(model, analyse_rows(model));
  }

  simbody::Model model;
  SideBySide<double> side;
  ReactionFrame frame;
};

/// Refuses in Simbody's place a mass matrix whose inverse Simbody would take from rounding.
void refuse_massless_motion(const Subject& subject, simbody::Way way) {
  const auto mobilizers = simbody::mobilizers(subject.model, way);
  const auto body = massless_motion(subject.frame.mechanism(), subject.frame.Phi(), mobilizers);
  if (!body) return;
  // an inertia that no body has Simbody refuses reliably, in its own words
  const auto& bodies = subject.frame.mechanism().bodies;
  if (!std::all_of(bodies.begin(), bodies.end(),
                   [](const auto& b) { return check_inertia(b.inertia).physical(); }))
    simbody::solve(subject.model, way);
  if (mobilizers.empty())
    throw simbody::Refused(fmt::format(
        "Simbody inverts the mass matrix of free bodies; body \"{}\" has no inertia about an axis", *body));
  throw simbody::Refused(
      fmt::format("Simbody inverts the mass matrix of its tree; body \"{}\" has no inertia about an axis "
                  "that the mobilizers leave free",
                  *body));
}

void compare(const Subject& subject, SimbodyComparison& out) {
  if (out.way == simbody::Way::mobilizers && simbody::mobilizers(subject.model, out.way).empty()) {
    out.possible = false;
    return;
  }
  refuse_massless_motion(subject, out.way);
  const simbody::Answer answer = simbody::solve(subject.model, out.way);
  const auto& [model, side, frame] = subject;
  const SimbodySolution theirs = to_trivium_solution(model, answer, frame);
  const VectorX<double> their_reactions = frame.stack(theirs.reactions);
  out.nc = frame.mechanism().nc();
  out.rank = side.rows.rank;
  out.kappa = side.rows.kappa;
  out.mobilizers = answer.mobilizers;
  out.constraint_rows = answer.constraint_rows;
  out.idle_rows = answer.idle_rows;
  out.pose_defect = answer.pose_defect;
  out.any_unique = side.any_unique();
  out.any_constraint = out.nc > 0;
  for (const FormulationResult<double>& ours : side.formulations) {
    SimbodyDistance d;
    d.formulation = ours.name;
    d.error = ours.error;
    if (ours.error.empty()) {
      d.acceleration = acceleration_distance(side.rows, ours.solution, theirs.solution).all;
      d.lambda = lambda_distance(side.rows, ours.solution.lambda, theirs.solution.lambda);
      d.reaction = relative_distance(frame.stack(frame.reactions(ours)), their_reactions,
                                     side.rows.acceleration_bound);
    }
    out.formulations.push_back(d);
  }
}

}  // namespace

double SimbodyComparison::bound() const {
  return std::max(1e-10, lambda_bound(unit_roundoff<double>(), kappa));
}

SimbodyDistance SimbodyComparison::worst() const {
  SimbodyDistance worst;
  for (const SimbodyDistance& d : formulations) {
    worst.acceleration = std::max(worst.acceleration, d.acceleration);
    worst.lambda = std::max(worst.lambda, d.lambda);
    worst.reaction = std::max(worst.reaction, d.reaction);
  }
  return worst;
}

bool SimbodyComparison::solved() const {
  return possible && failure.empty() && error.empty() &&
         std::all_of(formulations.begin(), formulations.end(),
                     [](const SimbodyDistance& d) { return d.error.empty(); });
}

bool SimbodyComparison::agrees() const {
  const SimbodyDistance d = worst();
  return solved() && std::max({d.acceleration, d.lambda, d.reaction}) <= bound();
}

std::string_view name_of(simbody::Way way) {
  switch (way) {
    case simbody::Way::mobilizers:
      return "mobilizers";
    case simbody::Way::free_bodies:
      return "free bodies";
    case simbody::Way::built_in:
      return "built-in";
  }
  return "";
}

std::vector<SimbodyComparison> compare_with_simbody(const scenes::Scene& scene, double t) {
  std::optional<Subject> subject, twin;
  const auto compare_scene = [&](SimbodyComparison& out) {
    if (!subject) subject.emplace(scene, t);
    compare(*subject, out);
  };
  const auto compare_twin = [&](SimbodyComparison& out) {
    if (!twin) twin.emplace(physical_twin(scene), t);
    compare(*twin, out);
  };
  std::vector<SimbodyComparison> ways;
  for (const auto way : {simbody::Way::mobilizers, simbody::Way::free_bodies, simbody::Way::built_in}) {
    SimbodyComparison& out = ways.emplace_back();
    out.scene = scene.name;
    out.way = way;
    out.nb = static_cast<int>(scene.bodies.size());
    try {
      try {
        compare_scene(out);
      } catch (const simbody::Refused& refused) {
        out.twin = true;
        out.refusal = refused.what();
        compare_twin(out);
      }
    } catch (const simbody::Refused& refused) {
      out.failure = refused.what();
    } catch (const ModelError& error) {
      out.error = error.what();
    }
  }
  return ways;
}

}  // namespace trivium
