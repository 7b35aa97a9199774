/// Solves a scene in every formulation and, in one of the ways of rebuilding it, by Simbody, and computes the
/// relative differences.

#include "validation/simbody/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/raise.hpp"
#include "bodies/inertia.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/so3.hpp"
#include "scenes/make_mechanism.hpp"
#include "validation/simbody/massless_motion.hpp"
#include "validation/simbody/physical_inertia.hpp"
#include "validation/simbody/simbody_solution.hpp"
#include "validation/simbody/translation.hpp"

namespace trivium {

namespace {

double relative_distance(const VectorX<double>& a, const VectorX<double>& b, double cause) {
  const double difference = (a - b).norm();
  return difference == 0 ? 0.0 : difference / std::max({a.norm(), b.norm(), cause});
}

/// The data that all comparisons of one scene share.
struct Subject {
  Subject(const scenes::Scene& scene, Model<double> model_of_scene)
      : made(std::move(model_of_scene)),
        model(to_simbody(scene, made)),
        side(side_by_side(made, analyse_rows(made))),
        frame(made, side.rows) {}
  Subject(const Subject&) = delete;

  const Model<double> made;
  const simbody::Model model;
  const SideBySide<double> side;
  const ReactionFrame frame;
};

/// Throws Refused if the mass matrix that Simbody would invert is singular up to rounding
/// (massless_motion.hpp).
void refuse_massless_motion(const Subject& subject, simbody::Way way) {
  const auto mobilizers = simbody::mobilizers(subject.model, way);
  const auto body = massless_motion(subject.made.mechanism, subject.frame.Phi(), mobilizers);
  if (!body) return;
  // If an inertia is unphysical, Simbody refuses it reliably: its own message is preferred.
  const auto& bodies = subject.made.mechanism.bodies;
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
  const auto& [made, model, side, frame] = subject;
  const SimbodySolution theirs = to_trivium_solution(model, answer, frame);
  const VectorX<double> their_reactions = frame.stack(theirs.reactions);
  out.nc = made.mechanism.nc();
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
    raise(worst.acceleration, d.acceleration);
    raise(worst.lambda, d.lambda);
    raise(worst.reaction, d.reaction);
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
  return solved() && d.acceleration <= bound() && d.lambda <= bound() && d.reaction <= bound();
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

std::vector<SimbodyComparison> compare_with_simbody(const NamedScene& named) {
  std::optional<Subject> subject, twin;
  const auto compare_scene = [&](SimbodyComparison& out) {
    if (!subject) subject.emplace(named.scene, named.model());
    compare(*subject, out);
  };
  const auto compare_twin = [&](SimbodyComparison& out) {
    if (!twin) {
      const scenes::Scene scene = physical_twin(named.scene);
      twin.emplace(scene, make_model<double>(scene, named.t));
    }
    compare(*twin, out);
  };
  std::vector<SimbodyComparison> ways;
  for (const auto way : {simbody::Way::mobilizers, simbody::Way::free_bodies, simbody::Way::built_in}) {
    SimbodyComparison& out = ways.emplace_back();
    out.scene = named.scene.name;
    out.way = way;
    out.nb = static_cast<int>(named.scene.bodies.size());
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
