#pragma once
/// Decides whether a results file obeys its schema, and whether two results files agree. The rules of the
/// columns are defined in results_schema.hpp and applied here.

#include <string>
#include <vector>

#include "results/tools/results_schema.hpp"
#include "results/tools/results_table.hpp"

namespace trivium {

/// One violation. `row` is empty if the violation concerns the whole file, `column` if it concerns a whole
/// row.
struct Difference {
  std::string row, column, accepted, regenerated, rule;
};

/// Checks one file on its own: the schema's command wrote it, it is unchanged since, it has the schema's
/// columns, its row keys are unique, and its numbers are within their bounds. The member `regenerated` of a
/// Difference holds the violating value if the argument is true, else the member `accepted`.
std::vector<Difference> check_results(const ResultsSchema& schema, const ResultsTable& table,
                                      bool regenerated = false);

/// Compares the rows of two files that both have the schema's columns. Rows with equal keys are compared.
std::vector<Difference> compare_rows(const ResultsSchema& schema, const ResultsTable& accepted,
                                     const ResultsTable& regenerated);

/// Checks both files on their own, and compares their rows if both have the schema's columns.
std::vector<Difference> compare_results(const ResultsSchema& schema, const ResultsTable& accepted,
                                        const ResultsTable& regenerated);

}  // namespace trivium
