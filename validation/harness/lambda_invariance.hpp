#pragma once
/// Is lambda the same number in every formulation? For catalogue scenes and random mechanisms, the largest
/// relative difference of lambda between formulations, in the norm of E = diag(Phi M^-1 Phi^T)^(1/2), against
/// 100 u kappa. The program over any list of formulations: who has one outside the library joins with
/// AllFormulations::With<Mine>.

#include <functional>
#include <string>
#include <vector>

#include "formulations/side_by_side.hpp"

namespace trivium {

/// Their names, and the solution of a model in all of them.
struct ComparedFormulations {
  std::vector<std::string> names;
  std::function<SideBySide<double>(const Model<double>&)> solve;
};

/// For another list than the library's, include formulations/side_by_side_impl.hpp and what it needs
/// (docs/extending.md).
template <class List = AllFormulations>
ComparedFormulations compared_formulations() {
  return {List::names(),
          [](const Model<double>& model) { return side_by_side<List>(model, analyse_rows(model)); }};
}

/// Runs the program with its command line; the exit code.
int lambda_invariance(int argc, char** argv, const ComparedFormulations& formulations);

}  // namespace trivium
