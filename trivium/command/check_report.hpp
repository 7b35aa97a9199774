#pragma once
/// The report of `trivium check` on a scene and its state, as text and as JSON: rank and dependent rows,
/// residuals of the constraints, energy, and the sparsity of the augmented matrix of every formulation. It
/// prints a Check (trivium/solve.hpp) and decides nothing itself.

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
  std::vector<std::string> dependent() const;
  std::vector<std::string> not_unique() const;
};

}  // namespace trivium
