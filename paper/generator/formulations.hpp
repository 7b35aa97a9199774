#pragma once
/// The formulations of a table of the paper: those that its results file has, in that order, so that whoever
/// enters the list of formulations has a column. How the paper writes them stands here alone.

#include <string>
#include <vector>

#include "paper/generator/tex.hpp"
#include "results/tools/results_table.hpp"

namespace trivium::paper {

/// What a column of the file says, each once, in the order of the rows.
std::vector<std::string> distinct(const ResultsTable& table, const std::string& column);

/// As distinct(table, "formulation"). Throws a ResultsError where a block of rows, one for every formulation
/// and each of `rows_each`, does not fill the file.
std::vector<std::string> formulations_of(const ResultsTable& table, std::size_t rows_each = 1);

/// As the paper writes it; by its name where paper.tex has no command for it.
Tex heading(const std::string& formulation);

/// "& & \multicolumn..." over `columns` columns each.
Tex headings_over(const std::vector<std::string>& formulations, std::size_t columns);

}  // namespace trivium::paper
