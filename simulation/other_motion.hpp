#pragma once
/// A motion of another code, as a CSV file has it: columns of numbers at times. Columns have the names of the
/// library's own files (motion_csv.hpp), or are given them.

#include <map>
#include <string>
#include <vector>

namespace trivium {

struct OtherMotion {
  struct Column {
    std::string theirs, ours;   ///< names
    std::vector<double> value;  ///< at every time
  };
  std::vector<double> t;  ///< [s], ascending
  std::vector<Column> columns;
  std::vector<std::string> unknown;  ///< columns whose names are none of ours
};

/// `ours`: the library's names, of which "t" must be there. `names`: ours by theirs. Throws an Error of kind
/// input that names the file, the place in it, what was found and what is accepted.
OtherMotion read_motion(const std::string& file, const std::map<std::string, std::string>& names,
                        const std::vector<std::string>& ours);

}  // namespace trivium
