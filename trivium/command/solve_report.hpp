#pragma once
/// The report of `trivium solve` on the solution at one state, as text and as JSON: accelerations, lambda and
/// reactions of every formulation, estimated errors, dependent rows. state_check.hpp decides the warnings.

#include <string>
#include <vector>

#include "base/json_writer.hpp"
#include "formulations/side_by_side.hpp"
#include "scenes/scene.hpp"

namespace trivium {

/// The report in one Scalar; compiled for every Scalar of the option --scalar.
template <class Scalar>
struct SolveReport {
  const scenes::Scene& scene;
  double t;
  const std::string& scalar;  ///< the name of the Scalar on the command line
  const char* solver;         ///< "printed" or "structured"
  const Mechanism<Scalar>& mechanism;
  const SideBySide<Scalar>& result;

  std::string text() const;
  std::string json() const;

 private:
  int dof() const { return 6 * mechanism.nb() - result.rows.rank; }
  std::vector<const FormulationResult<Scalar>*> solved() const;
  void write_formulation(JsonWriter& json, const FormulationResult<Scalar>& f) const;
  std::string lambda_table() const;
  std::string acceleration_table() const;
  std::string reaction_table() const;
};

}  // namespace trivium
