#pragma once
/// A motion of another code, read from a CSV file: a column of times and columns of numbers. Columns are
/// recognised by the names in the library's own files (motion_csv.hpp), or by a map from other names to them.

#include <map>
#include <string>
#include <vector>

namespace trivium {

/// The numbers of another code's motion, in the units and frames of motion_csv.hpp.
struct OtherMotion {
  /// A recognised column.
  struct Column {
    std::string theirs, ours;   ///< the name in the file, and the library's name
    std::vector<double> value;  ///< one number per time
  };
  std::vector<double> t;  ///< times [s], ascending
  std::vector<Column> columns;
  std::vector<std::string> unknown;  ///< names of columns that are not recognised
};

/// Reads a file. `names` maps names of the file to names of the library; `ours` lists the library's names.
/// Throws an Error of kind input that names the file, the line and column, the text found and what is
/// accepted; also if the file has no column "t".
OtherMotion read_motion(const std::string& file, const std::map<std::string, std::string>& names,
                        const std::vector<std::string>& ours);

}  // namespace trivium
