#pragma once
/// SUNDIALS' integrators (Hindmarsh and others, 2005; Gardner and others, 2022), in double: CVODE's Adams and
/// backward differentiation, and ARKODE's explicit and diagonally implicit Runge-Kutta methods, all on
/// y' = f(t, y); IDA's backward differentiation on the stabilised index 2. Newton's matrices are the system's
/// own, factored by it. CVODE and IDA step over outputs and interpolate there, by the polynomial of their
/// last step.

#include <memory>
#include <optional>
#include <vector>

#include "integrators/method_entry.hpp"

namespace trivium::integrators {

using DoubleMethod = std::unique_ptr<AnyMethod<double>>;

/// The entries of the list, in double. A new one is an entry in methods.cpp.
std::vector<MethodEntry<double>> sundials_methods();

/// Orders 1 to 12, solved by fixed-point iteration.
DoubleMethod make_cvode_adams(const Tolerances& tolerances);

/// Orders 1 to 5. Where it `projects`, states are projected before a step counts as solved (Eich, 1993).
DoubleMethod make_cvode_bdf(const Tolerances& tolerances, bool projects);

/// Of an order in 2, 3, 4, 5, 6, 8 where explicit and 2 to 5 where implicit; without tolerances at steps of
/// the grid's length.
DoubleMethod make_arkode(bool is_implicit, int order, const std::optional<Tolerances>& tolerances);

/// Gear, Gupta and Leimkuhler (1985); orders 1 to 5; states are projected after each step.
DoubleMethod make_ida(const Tolerances& tolerances);

}  // namespace trivium::integrators
