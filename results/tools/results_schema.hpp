#pragma once
/// results/schema.json as data: the question and the columns of every results file, and the command that
/// makes it again. Decided there: the rule, with its tolerance, by which two values of a column count as
/// equal.

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace trivium {

/// A number, or `times` the number in another column of the same row.
struct Quantity {
  double times = 0;
  std::string column;  ///< empty: a plain number
};

/// The same text: names, integers, verdicts.
struct Exact {};

/// Shown but never compared: timings, other programs' wording. Only the CSV's checksum guards it.
struct Shown {};

/// |a - b| <= tolerance max(|a|, |b|).
struct Relative {
  double tolerance = 0;
};

/// What rounding left, which differs from compiler to compiler and from CPU to CPU: each value is in [0,
/// bound], and the larger is at most `factor` times the smaller, where whatever is under `floor` counts as
/// the floor.
struct Rounding {
  Quantity bound, floor;
  double factor = 0;
};

using Rule = std::variant<Exact, Shown, Relative, Rounding>;

/// What one file's column is. A name with a `*` is that of one column or of several side by side: one for
/// each pair of formulations, say.
struct ColumnSchema {
  std::string name, meaning, unit;
  Rule rule;
};

struct ResultsSchema {
  std::string name, question;
  std::vector<std::string> command;  ///< makes the file again, with --csv FILE behind it
  std::vector<std::string> key;      ///< the columns that tell rows apart
  std::vector<ColumnSchema> columns;
};

/// All files of the schema, by name. Throws ResultsError and std::filesystem::filesystem_error.
std::vector<ResultsSchema> read_schema(const std::filesystem::path& file);

/// With a column for each that a `*` stands for in a file of these columns.
ResultsSchema expanded(ResultsSchema schema, const std::vector<std::string>& columns);

/// Throws a ResultsError where the schema does not know the name.
const ResultsSchema& find_schema(const std::vector<ResultsSchema>& all, const std::string& name);

}  // namespace trivium
