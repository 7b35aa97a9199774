#pragma once
/// AccelerationSolver: the check of the dependent rows. A candidate that the solution violates is independent
/// and is put back, or it contradicts the others, which is an error. A part of acceleration_solver_impl.hpp.

#include <fmt/format.h>

#include <utility>

#include "bodies/numbers/scalar.hpp"
#include "formulations/structured/acceleration_solver.hpp"

namespace trivium {

template <Formulation F>
void AccelerationSolver<F>::check_dependent_rows() {
  if (candidate_edges_.empty()) return;
  const auto size_here = [&](int b) { return size_of_causes(b); };
  if (!solver_.has_nearly_dependent_rows() &&
      !find_violated_row(solution_, row_rounding<S>(), S(0), size_here))
    return;
  decide_dependent_rows();
  const S tolerance = contradiction_tolerance_in<S>(mechanism_.rank_tolerance),
          least = S(contradiction_floor);
  if (!find_violated_row(solution_, S(share_without_doubt * tolerance), least, size_here)) return;
  AccelerationSize<S> whole, turning;
  for (int b = 0; b < mechanism_.nb(); ++b) {
    whole.take(size_of_causes(b));
    turning.take(size_of_turning(b));
  }
  if (const auto row = find_violated_row(solution_, tolerance, least, [&](int) { return whole; }))
    throw_violated(*row);
  // The violation may be rounding error of large forces anywhere in the mechanism. The same system is solved
  // without forces, so that only the right sides of the rows act. A violation that is still there is a
  // contradiction.
  for (BodyPart<S>& force : right_side_.body) force = {};
  solver_.solve(right_side_, step_);
  solver_.correct(assembly_.matrix(), right_side_, step_, residual_, residual_);
  whole = turning;
  for (int b = 0; b < mechanism_.nb(); ++b) {
    step_.body[b] += residual_.body[b];
    push_body(b);
    whole.take(AccelerationSize<S>::of(step_.body[b]));
  }
  if (const auto row = find_violated_row(step_, tolerance, least, [&](int) { return whole; }))
    throw_violated(*row);
}

template <Formulation F>
template <class SizeOfBody>
std::optional<EdgeRow> AccelerationSolver<F>::find_violated_row(const GraphVector<S>& solution,
                                                                const S& tolerance, const S& least,
                                                                const SizeOfBody& size_of_body) const {
  return trivium::find_violated_row<S>(solver_, candidate_edges_, assembly_.matrix(), right_side_, solution,
                                       tolerance, least, size_of_body);
}

template <Formulation F>
AccelerationSize<typename F::Scalar> AccelerationSolver<F>::size_of_causes(int b) const {
  const S moments = assembly_.matrix().H[b].xx.diagonal().sum();
  const auto force = AccelerationSize<S>::of(right_side_.body[b]);
  auto size = AccelerationSize<S>::of(solution_.body[b]);
  size.take({S(force.r / mechanism_.bodies[b].mass), select(moments > S(0), S(force.x / moments), S(0))});
  size.take(size_of_turning(b));
  return size;
}

template <Formulation F>
Place AccelerationSolver<F>::place_of(const EdgeRow& row) const {
  const int of_mechanism = plan().graph.edges[row.edge].rows[row.k];
  return {fmt::format("row \"{}\"", mechanism_.row_names[of_mechanism]), static_cast<double>(t_)};
}

template <Formulation F>
void AccelerationSolver<F>::decide_dependent_rows() {
  if (std::exchange(rows_are_decided_, true)) return;
  try {
    if (!solver_.restore_independent_rows()) return;
  } catch (const NearlyDependentRows& e) {
    throw ModelError(
        place_of(e.first_too_many),
        fmt::format(
            "more than {} rows, among them this one, are nearly dependent on others. Often the positions "
            "violate their constraints slightly: assemble the mechanism first, or solve the printed system",
            solver_.most_restored));
  }
  solver_.solve(right_side_, solution_);
  if (refinement_ == Refinement::as_needed) refine_as_needed();
}

template <Formulation F>
[[noreturn]] void AccelerationSolver<F>::throw_violated(const EdgeRow& row) const {
  require_numbers();
  throw ModelError(place_of(row),
                   "this row depends on other rows but contradicts them, so no acceleration satisfies all. "
                   "Remove a row, or make the functions of time consistent. If the row is independent by "
                   "less than the rounding error, take a wider Scalar or solve the printed system");
}

}  // namespace trivium
