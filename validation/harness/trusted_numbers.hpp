#pragma once
/// Numbers from other codes and from publications, with which motions are compared: the tables in
/// validation/reference/*.csv. Each table states the source of its numbers.

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/csv.hpp"

namespace trivium {

/// The folder of the tables: $TRIVIUM_REFERENCE if set, else `reference` next to the installed catalogue,
/// else the folder in the source tree.
std::string reference_directory();

/// A table of numbers with named columns. If a column is called `name`, it holds the names of the rows.
struct TrustedNumbers {
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> columns;

  /// Reads DIRECTORY/NAME.csv. Throws std::runtime_error if there is no such file.
  TrustedNumbers(const std::string& directory, const std::string& name) {
    const std::string path = directory + "/" + name + ".csv";
    std::ifstream file(path);
    if (!file)
      throw std::runtime_error(
          path + ": cannot be read; set TRIVIUM_REFERENCE to the folder of the reference tables");
    std::string table;
    for (std::string line; std::getline(file, line);)
      if (!line.starts_with('#')) table += line + "\n";
    const std::vector<std::vector<std::string>> records = parse_csv(table);
    const std::vector<std::string>& header = records.at(0);
    for (std::size_t row = 1; row < records.size(); ++row)
      for (std::size_t k = 0; k < header.size(); ++k)
        if (header[k] == "name")
          names.push_back(records[row].at(k));
        else
          columns[header[k]].push_back(std::stod(records[row].at(k)));
  }

  std::size_t rows() const { return columns.begin()->second.size(); }
  const std::vector<double>& operator[](const std::string& column) const { return columns.at(column); }
  /// The value in the row with this name.
  double value(const std::string& name) const {
    for (std::size_t k = 0; k < names.size(); ++k)
      if (names[k] == name) return columns.at("value")[k];
    throw std::runtime_error("the reference table has no value " + name);
  }
};

/// The angles [rad] about z of the bodies of Andrews' squeezer at the only time of the table, in the scene's
/// order.
inline std::array<double, 7> andrews_angles(const TrustedNumbers& file) {
  const auto value = [&](const char* name) { return file.value(name); };
  return {value("beta"),  value("beta") + value("theta"),    value("gamma"),  value("phi") + value("delta"),
          value("delta"), value("omega") + value("epsilon"), value("epsilon")};
}

/// The difference [rad] between an angle and the rotation about z that Euler parameters p describe.
template <class EulerParameters>
double apart_from_angle(const EulerParameters& p, double angle) {
  return std::abs(std::remainder(2 * std::atan2(p[3], p[0]) - angle, 2 * std::acos(-1.0)));
}

}  // namespace trivium
