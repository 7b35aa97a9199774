#pragma once
/// What `trivium check` says of a scene and its state, as text and as JSON: rank and dependent (redundant)
/// rows, residuals of the constraints, energy, and how sparse the augmented matrix of every formulation is.
/// It decides nothing; the analysis is formulations/analysis.

#include <optional>
#include <string>
#include <vector>

#include "formulations/analysis/consistency.hpp"
#include "formulations/analysis/row_analysis.hpp"
#include "formulations/printed/sparsity.hpp"
#include "scenes/scene.hpp"

namespace trivium {

struct StateEnergy {
  double kinetic = 0, potential = 0;  ///< [J]
  double power = 0;                   ///< of the effects [W]
};

struct CheckReport {
  const scenes::Scene& scene;
  double t;
  const Mechanism<double>& mechanism;
  const std::optional<RowAnalysis>& analysis;  ///< none where it would be too large
  const Consistency& consistency;
  const StateEnergy& energy;
  const std::vector<Sparsity>& sparsity;

  std::string text() const;
  std::string json() const;
  /// Rows that no acceleration satisfies beside the rows before them.
  std::vector<std::string> contradictory() const;

 private:
  std::vector<std::string> row_names(bool (*chosen)(const RowAnalysis&, int)) const;
  std::vector<std::string> redundant() const;
  std::vector<std::string> not_unique() const;
  std::vector<std::string> unphysical() const;
};

}  // namespace trivium
