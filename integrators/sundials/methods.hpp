#pragma once
/// The integrators of SUNDIALS (Hindmarsh and others, 2005; Gardner and others, 2022), in double. CVODE
/// (Adams and BDF) and ARKODE (explicit and diagonally implicit Runge-Kutta) integrate y' = f(t, y); IDA
/// (BDF) solves the stabilised index-2 equations. The system factors their Newton matrices with its own
/// solver. CVODE and IDA step over outputs and interpolate there by the polynomial of their last step.

#include <memory>
#include <optional>
#include <vector>

#include "integrators/method_entry.hpp"

namespace trivium::integrators {

/// A method in double.
using DoubleMethod = std::unique_ptr<AnyMethod<double>>;

/// The entries of the list, in double. To add a method, add an entry in methods.cpp.
std::vector<MethodEntry<double>> sundials_methods();

/// Adams methods of orders 1 to 12, solved by fixed-point iteration.
DoubleMethod make_cvode_adams(const Tolerances& tolerances);

/// BDF of orders 1 to 5. If `projects`, a state is also projected before its step is accepted (Eich, 1993).
DoubleMethod make_cvode_bdf(const Tolerances& tolerances, bool projects);

/// Runge-Kutta methods: explicit of order 2, 3, 4, 5, 6 or 8, implicit of order 2 to 5. Without tolerances
/// they take given steps.
DoubleMethod make_arkode(bool is_implicit, int order, const std::optional<Tolerances>& tolerances);

/// BDF of orders 1 to 5 for the equations of Gear, Gupta and Leimkuhler (1985). The method itself projects
/// the state at the end of each step, which removes the small violations that the iteration leaves. This
/// projection is part of the method: SimulationOptions::projects, which concerns the projection by integrate,
/// does not switch it off.
DoubleMethod make_ida(const Tolerances& tolerances);

}  // namespace trivium::integrators
