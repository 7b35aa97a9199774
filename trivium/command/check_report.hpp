#pragma once
/// What `trivium check` says of a scene and its state, as text and as JSON: rank and dependent (redundant)
/// rows, residuals of the constraints, energy, and how sparse the augmented matrix of every formulation is.
/// It decides nothing; what it prints is the front door's Check.

#include <string>
#include <vector>

#include "formulations/printed/sparsity.hpp"
#include "scenes/scene.hpp"
#include "trivium/solve.hpp"

namespace trivium {

struct CheckReport {
  const scenes::Scene& scene;
  const Check& check;
  const std::vector<Sparsity> sparsity;

  std::string text() const;
  std::string json() const;

 private:
  std::vector<std::string> row_names(bool (*chosen)(const RowCheck&)) const;
  std::vector<std::string> redundant() const;
  std::vector<std::string> not_unique() const;
};

}  // namespace trivium
