#pragma once
/// The tables of the paper.
///
/// To add a table:
///   1. results/schema.json: describe the results file that the table reads, if the file is new;
///      then ./run accept
///   2. paper/generator/NAME_table.cpp: write a function NAME_table() of the type MakeTable;
///      name the file in paper/CMakeLists.txt
///   3. this header: declare the function and add a line to paper_tables
///   4. paper.tex: input tables/NAME, and use the numbers that the function defines
/// The tests with the label `paper` then cover the new table.

#include <filesystem>
#include <map>
#include <string>

#include "paper/generator/tex.hpp"
#include "results/tools/results_table.hpp"

namespace trivium::paper {

/// The accepted results, read on first use. Throws a ResultsError if a file violates its schema or was
/// changed after its program wrote it.
class Results {
 public:
  explicit Results(std::filesystem::path directory) : directory_(std::move(directory)) {}
  const ResultsTable& operator[](const std::string& name);

 private:
  std::filesystem::path directory_;
  std::map<std::string, ResultsTable> read_;
};

/// Returns the LaTeX of a table and defines the numbers that the text around it quotes.
using MakeTable = std::string(Results&, Numbers&);

MakeTable lambda_invariance_table, motion_invariance_table, precision_ladder_table, simbody_reference_table,
    instruction_counts_table, acceleration_cost_table, cost_of_chains_figure, cost_of_ladders_figure,
    convergence_order_table, analytic_solutions_table, formulation_speed_table, work_precision_table,
    hard_cases_table, gimbal_lock_figure, slopes_of_positions_figure, slopes_of_lambda_figure,
    work_on_two_bars_figure, work_on_the_governor_figure;

struct PaperTable {
  const char* name;
  MakeTable* make;
};
inline constexpr PaperTable paper_tables[] = {{"lambda_invariance", lambda_invariance_table},
                                              {"motion_invariance", motion_invariance_table},
                                              {"precision_ladder", precision_ladder_table},
                                              {"simbody_reference", simbody_reference_table},
                                              {"instruction_counts", instruction_counts_table},
                                              {"acceleration_cost", acceleration_cost_table},
                                              {"cost_of_chains", cost_of_chains_figure},
                                              {"cost_of_ladders", cost_of_ladders_figure},
                                              {"convergence_order", convergence_order_table},
                                              {"analytic_solutions", analytic_solutions_table},
                                              {"formulation_speed", formulation_speed_table},
                                              {"work_precision", work_precision_table},
                                              {"hard_cases", hard_cases_table},
                                              {"gimbal_lock", gimbal_lock_figure},
                                              {"slopes_of_positions", slopes_of_positions_figure},
                                              {"slopes_of_lambda", slopes_of_lambda_figure},
                                              {"work_on_two_bars", work_on_two_bars_figure},
                                              {"work_on_the_governor", work_on_the_governor_figure}};

/// The generated files of paper/tables: names and contents.
std::map<std::string, std::string> render(const std::filesystem::path& results);

}  // namespace trivium::paper
