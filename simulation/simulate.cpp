/// Turns the name of the formulation into its type, and refuses methods that do not go with it.

#include "simulation/simulate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <type_traits>

#include "bodies/numbers/quad.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/analysis/tangent_system.hpp"
#include "formulations/formulation_list.hpp"
#include "integrators/methods.hpp"
#include "simulation/simulate_in.hpp"

namespace trivium {

namespace {

bool inertia_is_constant(const std::string& formulation) {
  return with_formulation<double>(formulation, []<Formulation F>() { return F::inertia_is_constant; });
}

void check_that_it_goes(const integrators::MethodInfo& method, const std::string& formulation) {
  if (goes_with(method, formulation)) return;
  std::vector<std::string> accepted = formulation_names();
  std::erase_if(accepted, [](const std::string& name) { return !inertia_is_constant(name); });
  throw integrators::UsageError(fmt::format(
      "{} needs a formulation whose mass matrix does not depend on positions, unlike {}; accepted: {}",
      method.name, formulation, fmt::join(accepted, ", ")));
}

/// Warnings of rows that the rank tolerance only just keeps or leaves out at the start. A mechanism of more
/// than 300 unknowns is not analysed, since this would cost more than a short motion, nor one that the dense
/// analysis refuses.
std::vector<std::string> narrow_rows_at(const Model<double>& model) {
  constexpr int most_unknowns = 300;
  if (6 * model.mechanism.nb() + model.mechanism.nc() > most_unknowns) return {};
  try {
    return narrow_row_warnings(model.mechanism.row_names,
                               analyse_rows(tangent_system(model.mechanism, model.state)),
                               standard_rank_tolerance);
  } catch (const ModelError&) {
    return {};
  }
}

}  // namespace

bool goes_with(const integrators::MethodInfo& method, const std::string& formulation) {
  return !method.needs_constant_inertia || inertia_is_constant(formulation);
}

template <class Scalar>
SimulationReport simulate(const Model<Scalar>& model, const SimulationOptions& options,
                          SimulationObserver& observer) {
  check_that_it_goes(options.own_method ? options.own_method->info
                                        : integrators::method_entry<double>(options.integrator).info,
                     options.formulation);
  if (std::is_same_v<Scalar, double> && model.mechanism.rank_tolerance < standard_rank_tolerance)
    throw integrators::UsageError(
        fmt::format("the rank tolerance is {:.3g}; accepted in simulations: {:.0e} to {:.0e}, since the "
                    "linear-time solver computes the square of a row's independent share, which rounding "
                    "hides if it is smaller",
                    model.mechanism.rank_tolerance, standard_rank_tolerance, largest_rank_tolerance));
  std::vector<std::string> narrow_rows;
  if constexpr (std::is_same_v<Scalar, double>)
    if (options.watches) narrow_rows = narrow_rows_at(model);
  try {
    SimulationReport report = with_formulation<Scalar>(
        options.formulation, [&]<Formulation F>() { return simulate_in<F>(model, options, observer); });
    report.narrow_rows = std::move(narrow_rows);
    return report;
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::input || narrow_rows.empty()) throw;
    throw Error(error.kind(), fmt::format("{}. At the start, {}", error.what(), narrow_rows.front()),
                Place{error.where(), error.when()});
  }
}

template SimulationReport simulate<double>(const Model<double>&, const SimulationOptions&,
                                           SimulationObserver&);
template SimulationReport simulate<Quad>(const Model<Quad>&, const SimulationOptions&, SimulationObserver&);

}  // namespace trivium
