#pragma once
/// Sparse solvers of general use on the printed augmented matrix of r-omega: the pattern is analysed once,
/// and an evaluation is numeric factorisation and solve. The matrix is not assembled anew, which favours
/// them.

#include <memory>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "validation/cost/engine.hpp"

namespace trivium::cost {

/// Eigen's, and SuiteSparse's where it is installed.
std::vector<std::string> sparse_solvers();

/// Throws std::runtime_error where the solver does, and so does evaluate(); ModelError.
std::unique_ptr<Engine> sparse_engine(const scenes::Scene& scene, const std::string& solver);

}  // namespace trivium::cost
