#pragma once
/// The formulations of a table of the paper. They are read from the results file in its order, so that a new
/// formulation gets a column without changes here. This file alone decides how the paper writes a
/// formulation.

#include <string>
#include <vector>

#include "paper/generator/tex.hpp"
#include "results/tools/results_table.hpp"

namespace trivium::paper {

/// The distinct values of a column, in the order of the rows.
std::vector<std::string> distinct(const ResultsTable& table, const std::string& column);

/// distinct(table, "formulation"). The file must consist of blocks with `rows_each` rows for every
/// formulation; throws a ResultsError if the number of rows does not fit.
std::vector<std::string> formulations_of(const ResultsTable& table, std::size_t rows_each = 1);

/// The LaTeX of a formulation: its command in paper.tex, or its name if paper.tex has no command for it.
Tex heading(const std::string& formulation);

/// A heading line with each formulation centred over `columns` columns, after two empty cells.
Tex headings_over(const std::vector<std::string>& formulations, std::size_t columns);

}  // namespace trivium::paper
