#pragma once
/// Decides whether a results file is as its schema says, and whether two of them say the same. The rules are
/// in results_schema.hpp, one a column; here they are applied.

#include <string>
#include <vector>

#include "results/tools/results_schema.hpp"
#include "results/tools/results_table.hpp"

namespace trivium {

/// One thing that is not as it should be; row and column are empty where it is the whole file.
struct Difference {
  std::string row, column, accepted, regenerated, rule;
};

/// One file on its own: it is what the schema's command wrote and nobody changed since, with the schema's
/// columns, rows told apart by their keys, numbers within their bounds. `regenerated` says which side it is
/// reported on.
std::vector<Difference> check_results(const ResultsSchema& schema, const ResultsTable& table,
                                      bool regenerated = false);

/// The rows of two files with the schema's columns, matched by their keys.
std::vector<Difference> compare_rows(const ResultsSchema& schema, const ResultsTable& accepted,
                                     const ResultsTable& regenerated);

/// Both files on their own; their rows, where both have the schema's columns.
std::vector<Difference> compare_results(const ResultsSchema& schema, const ResultsTable& accepted,
                                        const ResultsTable& regenerated);

}  // namespace trivium
