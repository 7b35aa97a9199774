#pragma once
/// One motion in several formulations, each stepped by itself, side by side through time: that of the program
/// `trivium compare`. Along the motion lambda agrees to the tolerance asked for, times what the motion makes
/// of a difference; at one state to 100 u kappa.

#include <optional>
#include <string>
#include <vector>

#include "trivium/simulate.hpp"

namespace trivium {

struct CompareSettings {
  std::vector<std::string> formulations = {};  ///< two or more; none: all that go with the integrator
  SimulateSettings run = {};  ///< its formulation and at_step are not used; without output_step 100 outputs
  int states = 10;  ///< so many outputs, evenly, are solved in every formulation at every one's state
};

/// One formulation's run.
struct ComparedMotion {
  std::string formulation, error;   ///< error: why it did not come to the end; empty where it did
  std::vector<std::string> charts;  ///< that bodies had at outputs
  long steps = 0, rejected_steps = 0, right_sides = 0, newton_iterations = 0, factorisations = 0;
  int chart_changes = 0;
  double seconds = 0;  ///< of processor time
  std::vector<std::string> warnings;
};

/// All formulations at one time. Differences are the largest between two, those of lambda and of
/// accelerations relative, in the norm of E and in the mass metric.
struct ComparedOutput {
  double t = 0;
  double lambda_difference = 0, lambda_bound = 0;  ///< along the motion
  double amplification = 1;                        ///< of a relative difference of the start, in lambda
  double position_difference = 0;                  ///< [m]
  double rotation_difference = 0;                  ///< [rad]
  bool is_judged = true;  ///< not beside singular positions, nor where neighbouring motions are elsewhere
  struct OneState {
    double lambda_difference = 0, lambda_bound = 0, acceleration_difference = 0, condition = 1;
  };
  std::optional<OneState> one_state;  ///< every formulation at the states of all others
};

struct ComparedMotions {
  std::vector<ComparedMotion> motions;
  std::vector<ComparedOutput> outputs;
  bool has_unique_lambda = true;  ///< else there is nothing to compare
  bool complete = false;          ///< every formulation came to the end
  bool holds_along = false;       ///< lambda is within its bound at every output that is judged
  bool holds_at_states = false;   ///< and at every state
};

/// Throws an Error of kind input where the state does not satisfy its constraints, or what is asked for does
/// not go together. What keeps one formulation from the end stands with it.
ComparedMotions compare(const Scene& scene, const CompareSettings& settings = {});

}  // namespace trivium
