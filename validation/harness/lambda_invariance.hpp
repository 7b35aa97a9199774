#pragma once
/// Question: is lambda the same number in every formulation? For scenes of the catalogue and random
/// mechanisms, the program computes the relative difference of lambda between pairs of formulations, in the
/// norm of E = diag(Phi_q M^-1 Phi_q^T)^(1/2). It fails if a solver fails, or if a difference exceeds the
/// bound 100 u kappa. The list of formulations is a parameter: a user-written formulation is added by
/// `AllFormulations::With<Mine>`.

#include <functional>
#include <string>
#include <vector>

#include "formulations/side_by_side.hpp"

namespace trivium {

/// The names of the formulations, and a function that solves a model in all of them.
struct ComparedFormulations {
  std::vector<std::string> names;
  std::function<SideBySide<double>(const Model<double>&)> solve;
};

/// The formulations of a list. For another list than the library's, include
/// formulations/side_by_side_impl.hpp and the headers of the formulations (docs/extending.md).
template <class List = AllFormulations>
ComparedFormulations compared_formulations() {
  return {List::names(),
          [](const Model<double>& model) { return side_by_side<List>(model, analyse_rows(model)); }};
}

/// Runs the program with its command line; returns the exit code.
int lambda_invariance(int argc, char** argv, const ComparedFormulations& formulations);

}  // namespace trivium
