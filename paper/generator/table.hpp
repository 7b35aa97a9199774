#pragma once
/// The tables of the paper.
///
/// To add one:
///   1. results/schema.json: describe the results file that it reads, if it is a new one; ./run accept
///   2. paper/generator/NAME_table.cpp: a function NAME_table() of the shape below, named in
///   paper/CMakeLists.txt
///   3. here: declare it and add a line to paper_tables
///   4. paper.tex: \input{tables/NAME}, and the numbers that the function defined
/// The tests of label `paper` then cover it: nothing else is to be written.

#include <filesystem>
#include <map>
#include <string>

#include "paper/generator/tex.hpp"
#include "results/tools/results_table.hpp"

namespace trivium::paper {

/// The accepted results, read when asked for. A file that is not what its schema says, or that was changed
/// since its program wrote it, is a ResultsError: nothing is printed from it.
class Results {
 public:
  explicit Results(std::filesystem::path directory) : directory_(std::move(directory)) {}
  const ResultsTable& operator[](const std::string& name);

 private:
  std::filesystem::path directory_;
  std::map<std::string, ResultsTable> read_;
};

/// Returns the table's LaTeX and defines the numbers that the text around it quotes.
using MakeTable = std::string(Results&, Numbers&);

MakeTable lambda_invariance_table, motion_invariance_table, precision_ladder_table, simbody_reference_table,
    instruction_counts_table, acceleration_cost_table, cost_of_chains_figure, cost_of_ladders_figure,
    convergence_order_table, analytic_solutions_table, formulation_speed_table, work_precision_table,
    slopes_of_positions_figure, slopes_of_lambda_figure, work_on_two_bars_figure, work_on_the_governor_figure;

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
                                              {"slopes_of_positions", slopes_of_positions_figure},
                                              {"slopes_of_lambda", slopes_of_lambda_figure},
                                              {"work_on_two_bars", work_on_two_bars_figure},
                                              {"work_on_the_governor", work_on_the_governor_figure}};

/// What paper/tables holds: file names and contents.
std::map<std::string, std::string> render(const std::filesystem::path& results);

}  // namespace trivium::paper
