/// Redundant rows: accelerations and the forces Phi_q^T lambda against the model without the dependent rows,
/// in quad.

#include <fmt/format.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/real50.hpp"
#include "bodies/numbers/scalar.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "formulations/structured_side_by_side.hpp"
#include "scenes/building.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/make_mechanism.hpp"
#include "validation/hard/factors.hpp"
#include "validation/hard/family.hpp"
#include "validation/hard/rank_jump.hpp"
#include "validation/hard/solved_state.hpp"

namespace trivium::hard {

namespace {

using building::joint, building::side;
using scenes::plain, scenes::Scene, scenes::Vector3;

/// The model with these rows alone. All count: the lower rank tolerance leaves out none of them.
template <class S>
Model<S> with_rows(const Model<S>& whole, const std::vector<int>& kept) {
  Model<S> model = whole;
  model.mechanism.rank_tolerance /= 100;
  model.mechanism.rows.clear();
  model.mechanism.row_names.clear();
  for (const int k : kept) {
    model.mechanism.rows.push_back(whole.mechanism.rows[k]);
    model.mechanism.row_names.push_back(whole.mechanism.row_names[k]);
  }
  for (Joint<S>& one : model.mechanism.joints) {
    const auto first = std::lower_bound(kept.begin(), kept.end(), one.first_row),
               last = std::lower_bound(kept.begin(), kept.end(), one.first_row + one.rows);
    one.first_row = static_cast<int>(first - kept.begin());
    one.rows = static_cast<int>(last - first);
  }
  return model;
}

/// The scene with its joints written as basic constraints (cd, dp1), every other of which is multiplied by a
/// factor. This divides its multiplier.
Scene with_scaled_rows(Scene scene, double factor) {
  const auto mechanism = make_model<double>(scene).mechanism;
  scene.constraints.clear();
  for (std::size_t k = 0; k < mechanism.rows.size(); ++k) {
    const BodyPair pair = bodies_of(mechanism.rows[k]);
    const auto body = [&](int b) { return b == mechanism.ground() ? scenes::ground : b; };
    const double by = k % 2 == 0 ? factor : 1;
    const std::string& name = mechanism.row_names[k];
    if (const auto* row = std::get_if<CD<double>>(&mechanism.rows[k])) {
      scene.constraints.push_back(joint(basic_type<CD>, name, side(body(pair.i), plain(row->s_bar_i)),
                                        side(body(pair.j), plain(row->s_bar_j))));
      scene.constraints.back().direction = plain(by * row->c);
    } else {
      const auto& angle = std::get<DP1<double>>(mechanism.rows[k]);
      scene.constraints.push_back(joint(basic_type<DP1>, name,
                                        building::vector_side(body(pair.i), plain(by * angle.a_bar_i)),
                                        building::vector_side(body(pair.j), plain(angle.a_bar_j))));
    }
  }
  return scene;
}

/// The components of lambda that are unique: those whose row of the null space of Phi_q^T is zero. By a
/// singular value decomposition of the Jacobian of r-omega, whose rows are normalised.
std::vector<bool> unique_components(const MatrixX<double>& Phi, int rank) {
  const MatrixX<double> normalised = Phi.rowwise().normalized();
  const Eigen::JacobiSVD<MatrixX<double>> svd(normalised.transpose(), Eigen::ComputeFullV);
  const MatrixX<double> null_space = svd.matrixV().rightCols(Phi.rows() - rank);
  std::vector<bool> unique;
  // far above rounding, and far below the components of a dependence of few rows
  for (Eigen::Index k = 0; k < Phi.rows(); ++k) unique.push_back(!(null_space.row(k).norm() > 1e-6));
  return unique;
}

double relative(const VectorX<double>& x, const VectorX<double>& exact) {
  const double off = (x - exact).lpNorm<Eigen::Infinity>();
  return off == 0 ? 0 : off / exact.lpNorm<Eigen::Infinity>();
}

/// Compares both solvers in all formulations with the model without the rows that each calls dependent.
/// `expected`: the rank, if it is known. `largest`: of the thresholds, whatever kappa is.
void compare_with_reduced(Judge& judge, const Scene& scene, std::optional<int> expected, double largest) {
  const auto model = make_model<double>(scene);
  const auto higher = make_model<NextPrecisionT<double>>(scene);
  const RowAnalysis rows = analyse_rows(model);
  const MatrixX<double> Phi = tangent_system(model.mechanism, model.state).Phi;
  const SolveOptions options{judge.formulations(), {}};
  const auto compare = [&](const SideBySide<double>& answer, const std::string& solver) {
    const std::vector<int>& kept = answer.rows.independent;
    const RowAnalysis reduced_rows = analyse_rows(with_rows(model, kept));
    const PhysicalSolution<double> exact =
        solution_in_quad(with_rows(make_model<Quad>(scene), kept), reduced_rows);
    VectorX<double> exact_lambda = VectorX<double>::Zero(Phi.rows());
    for (std::size_t k = 0; k < kept.size(); ++k) exact_lambda[kept[k]] = exact.lambda[k];
    const std::vector<bool> unique = unique_components(Phi, expected.value_or(answer.rows.rank));
    const auto unique_part = [&](VectorX<double> lambda) {
      for (std::size_t k = 0; k < unique.size(); ++k)
        if (!unique[k]) lambda[k] = 0;
      return lambda;
    };
    for (const FormulationResult<double>& found : answer.formulations) {
      Row row = judge.row(found.name, solver, "accelerations [-]");
      if (!found.error.empty()) {
        judge.add(judge.refused(row, found.error, scene));
        continue;
      }
      promise(row, reduced_rows.kappa, unit_roundoff<double>(), largest);
      row.value = compare_accelerations(reduced_rows, found.solution, exact).all.error();
      const double announced = stated_error(found);
      judge.add(judge.judged(row, announced));
      row.quantity = "unique lambda [-]";
      row.value = relative(unique_part(found.solution.lambda), unique_part(exact_lambda));
      judge.add(judge.judged(row, announced));
      row.quantity = "Phi_q^T lambda [-]";
      row.value = relative(Phi.transpose() * found.solution.lambda, Phi.transpose() * exact_lambda);
      judge.add(judge.judged(row, announced));
    }
    Row row = judge.row("all", solver, "rank and uniqueness [1]");
    row.value = std::abs(answer.rows.rank - expected.value_or(answer.rows.rank));
    for (std::size_t k = 0; k < unique.size(); ++k) row.value += answer.rows.unique[k] != unique[k];
    row.threshold = 0;
    row.why = fmt::format("rank {} of {} rows, {} unique", answer.rows.rank, unique.size(),
                          std::count(unique.begin(), unique.end(), true));
    judge.add(judge.judged(row));
  };
  compare(side_by_side(model, rows, options, &higher), "printed");
  compare(structured_side_by_side(model, options), "structured");
}

/// The scenes and their ranks.
constexpr std::pair<const char*, int> redundant_scenes[]{
    {"four_bar", 17}, {"bricard", 29}, {"door", 5}, {"parallelogram", 23}};

/// The scene with a bob that swings about the centre of its first body. In these scenes a dependence of rows
/// takes in every row; those of the bob are independent of all others, and their three multipliers unique.
Scene with_a_bob(Scene scene) {
  const scenes::Body& carrier = scene.bodies[0];
  const Vector3 arm{-0.2, 0.1, 0.3};
  scenes::Body bob = building::body("bob", 2, {0.1, 0.2, 0.15});
  for (int k = 0; k < 3; ++k) bob.position[k] = carrier.position[k] - arm[k];
  bob.velocity = carrier.velocity;
  scene.bodies.push_back(bob);
  scene.constraints.push_back(joint(JointType::spherical, "pivot", side(0, Vector3{}),
                                    side(static_cast<int>(scene.bodies.size()) - 1, arm)));
  return scene;
}
constexpr int bob_rows = 3;

/// Every joint but the bob's `copies` times.
void judge_copies(Judge& judge, double copies) {
  for (const auto& [name, rank] : redundant_scenes) {
    Scene scene = load_scene(name);
    const std::vector<scenes::Constraint> once = scene.constraints;
    for (int n = 1; n < static_cast<int>(copies); ++n)
      for (scenes::Constraint copy : once) {
        copy.name += fmt::format(" {}", n + 1);
        scene.constraints.push_back(copy);
      }
    judge.begin_part(name);
    compare_with_reduced(judge, with_a_bob(std::move(scene)), rank + bob_rows, factors::redundant);
  }
}

void judge_scaled_rows(Judge& judge, double factor) {
  for (const auto& [name, rank] : redundant_scenes) {
    judge.begin_part(name);
    compare_with_reduced(judge, with_scaled_rows(with_a_bob(load_scene(name)), factor), rank + bob_rows,
                         factors::redundant);
  }
}

/// Below the rank tolerance, 1e-8 of the rows' size, the door swings with rank 5, above it is locked by a
/// sixth row. The decade around the tolerance is left open.
void judge_misalignment(Judge& judge, double angle) {
  std::optional<int> rank;
  if (angle < 3e-9) rank = 5 + bob_rows;
  if (angle > 3e-8) rank = 6 + bob_rows;
  compare_with_reduced(judge, with_a_bob(misaligned_door(angle)), rank,
                       angle < 3e-9 ? factors::redundant : small_difference);
}

}  // namespace

Family redundancy() {
  return {"redundancy",
          "redundant rows, repeated, scaled, misaligned",
          {{"copies", "how often each joint is repeated", {1, 10, true}, 1, {2}, {2, 3}, judge_copies},
           {"scaled_rows",
            "factor of every other row",
            {1e-7, 1e7},
            1,
            {1e3},
            {1e3, 1e-3, 1e6, 1e-6},
            judge_scaled_rows},
           {"misaligned_door",
            "angle between the two axes [rad]",
            {0, 1},
            0,
            {1e-12, 1e-5},
            {1e-14, 1e-12, 1e-10, 1e-9, 1e-8, 1.1e-8, 1.3e-8, 1e-7, 1e-6, 1e-5, 1e-4},
            judge_misalignment,
            [](double angle) { return with_a_bob(misaligned_door(angle)); }},
           {"rank_jump", "angles per decade", {1, 1000, true}, 1, {100}, {10, 1000}, judge_rank_jump}}};
}

}  // namespace trivium::hard
