#pragma once
/// General sparse solvers applied to the printed augmented matrix of r-omega. The pattern is analysed once;
/// an evaluation is a numeric factorisation and a solution. The matrix is not assembled again, which favours
/// these solvers.

#include <memory>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "validation/cost/engine.hpp"

namespace trivium::cost {

/// The names of Eigen's solvers, and of SuiteSparse's if it is installed.
std::vector<std::string> sparse_solvers();

/// The engine with this solver. This function and evaluate() throw std::runtime_error if the solver fails;
/// this function also throws ModelError.
std::unique_ptr<Engine> sparse_engine(const scenes::Scene& scene, const std::string& solver);

}  // namespace trivium::cost
