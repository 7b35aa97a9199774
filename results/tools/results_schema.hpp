#pragma once
/// results/schema.json as data: for every results file its question, its columns, and the command that makes
/// it. Each column has a rule, with a tolerance, that decides when two values count as equal.

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace trivium {

/// A plain number, or `times` the number in another column of the same row.
struct Quantity {
  double times = 0;
  std::string column;  ///< empty for a plain number
};

/// The texts must be equal: names, integers, verdicts.
struct Exact {};

/// Values are not compared: timings, messages of other programs. Only the checksum of the CSV protects them.
struct Shown {};

/// Numbers must satisfy |a - b| <= tolerance max(|a|, |b|).
struct Relative {
  double tolerance = 0;
};

/// Numbers are rounding errors, which differ between compilers and CPUs. Each must lie in [0, bound], and the
/// larger must be at most `factor` times the smaller. A value below `floor` counts as `floor`.
struct Rounding {
  Quantity bound, floor;
  double factor = 0;
};

using Rule = std::variant<Exact, Shown, Relative, Rounding>;

/// A column of a results file. A name with a `*` stands for one or more adjacent columns, for example one for
/// each pair of formulations.
struct ColumnSchema {
  std::string name, meaning, unit;
  Rule rule;
};

struct ResultsSchema {
  std::string name, question;
  std::vector<std::string> command;  ///< command that makes the file; --csv FILE is appended
  std::vector<std::string> key;      ///< columns that identify a row
  std::vector<ColumnSchema> columns;
};

/// The schemas of all results files. Throws ResultsError and std::filesystem::filesystem_error.
std::vector<ResultsSchema> read_schema(const std::filesystem::path& file);

/// The schema with each `*` column replaced by the matching ones among `columns`.
ResultsSchema expanded(ResultsSchema schema, const std::vector<std::string>& columns);

/// The schema of one results file. Throws a ResultsError if there is none with this name.
const ResultsSchema& find_schema(const std::vector<ResultsSchema>& all, const std::string& name);

}  // namespace trivium
