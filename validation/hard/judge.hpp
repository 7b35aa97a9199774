#pragma once
/// Judges the runs of one case: by its error against the exact motion, or by what it announces.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bodies/numbers/scalar.hpp"
#include "simulation/neighbouring_start.hpp"
#include "validation/hard/exact_motion.hpp"
#include "validation/hard/row.hpp"

namespace trivium::hard {

/// What the command line asks for.
struct Choice {
  bool is_quick = false;
  std::vector<std::string> formulations;  ///< names; all if empty
  std::string program;                    ///< path of the program `trivium`, for the family of faults
};

class Judge {
 public:
  /// `name`: of the case, with its difficulty.
  Judge(std::string family, std::string name, bool is_twin, const Choice& choice);

  bool is_quick() const { return choice_.is_quick; }
  bool is_twin() const { return is_twin_; }
  const Choice& choice() const { return choice_; }
  /// The formulations of the command line, in the order of the list.
  const std::vector<std::string>& formulations() const { return formulations_; }

  /// The name of the case gets this part, for a case of several scenes.
  void begin_part(const std::string& part) { part_ = " " + part; }

  /// Ends the parts: of rows with the same formulation, method and quantity, only that of the worst part
  /// stays.
  void keep_worst_part();

  /// Runs a motion by all methods of the family in all formulations.
  ExactMotion motion(const HardMotion& motion);
  /// Adds Simbody's rows of a motion, unless formulations are chosen. Their reasons begin with the remark.
  void add_simbody(const HardMotion& motion, const ExactMotion& exact, const std::string& remark = {});

  /// A row that begins with the case's names; the caller completes it.
  Row row(const std::string& formulation, const std::string& method, const std::string& quantity) const;
  /// The row with its verdict. If its value exceeds the threshold, `figure` decides: the relative error that
  /// the program states by itself, which must be at least a tenth of the true one.
  Row judged(Row row, double figure = 0) const;
  /// The row of a case whose run from `start` to `end`, or solution at `start`, ended with this error, which
  /// has to contain the words of `reason`.
  Row ended(Row row, const std::string& message, std::optional<double> when, const scenes::Scene& scene,
            double start = 0, double end = 0, const std::string& reason = {}) const;
  /// The row of a state at t = 0 that a solver refuses with this message.
  Row refused(Row row, const std::string& message, const scenes::Scene& scene) const;
  /// The row for the exact motion itself: its difference from a law, `off`.
  Row exact_row(const std::string& law, double off, const ExactMotion& exact) const;
  void add(Row row) { rows_.push_back(std::move(row)); }

  const std::vector<Row>& rows() const { return rows_; }

 private:
  void run(const HardMotion& motion, const ExactMotion& exact, const std::string& formulation,
           const std::string& method, std::optional<double> step);

  std::string family_, name_, part_;
  bool is_twin_;
  Choice choice_;
  std::vector<std::string> formulations_;
  std::vector<Row> rows_;
};

/// What a run with given steps claims of its errors: the sum of local errors that it states, in units of the
/// exact motion, and the rounding of every body in every step. A method that meets the constraints knows
/// positions to the level at which its iterations end, and takes its velocities from them. Without a
/// statement, and at most, it claims that no warning is needed.
double stated_by(const SimulationReport& report, const ExactMotion& exact, double step);

/// Adds the warnings of a run to the row's reason. Returns the largest relative error that they state, at
/// most 1; the least positive number if they state none, and 0 if there are none.
double quote_warnings(Row& row, const SimulationReport& report);

/// Enters into the row of one state what is promised of it: a tolerance, amplified by kappa; the threshold is
/// at most `largest`.
void promise(Row& row, double kappa, double tolerance = unit_roundoff<double>(),
             double largest = small_difference);

/// Enters into the row the largest difference of the states from the exact ones, relative to its threshold
/// factor . row.tolerance . amplification. States whose threshold exceeds small_difference are not judged:
/// nothing is promised there. If this holds from the first state on, value and threshold are NaN. Says which
/// branch the states are on; if not on their own, the difference is 1.
void judge_states(Row& row, const ExactMotion& exact, const std::vector<MechanismState<double>>& states,
                  double factor);

}  // namespace trivium::hard
