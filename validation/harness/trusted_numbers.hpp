#pragma once
/// Numbers of other codes and of publications that motions are compared with: the tables of
/// validation/reference/*.csv. Each table says where its numbers come from.

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/csv.hpp"

namespace trivium {

/// The folder of trusted numbers: $TRIVIUM_REFERENCE, else `reference` beside the catalogue, else the source
/// tree's.
std::string reference_directory();

/// A table of numbers by column; a first column of names is `name`.
struct TrustedNumbers {
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> columns;

  /// Throws a std::runtime_error where there is no such file.
  TrustedNumbers(const std::string& directory, const std::string& name) {
    const std::string path = directory + "/" + name + ".csv";
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": cannot be read; TRIVIUM_REFERENCE names its folder");
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
  /// Of a table of names.
  double value(const std::string& name) const {
    for (std::size_t k = 0; k < names.size(); ++k)
      if (names[k] == name) return columns.at("value")[k];
    throw std::runtime_error("no value " + name);
  }
};

/// Of Andrews' squeezer at the file's only time: every body's angle [rad] about z, in the scene's order.
inline std::array<double, 7> andrews_angles(const TrustedNumbers& file) {
  const auto value = [&](const char* name) { return file.value(name); };
  return {value("beta"),  value("beta") + value("theta"),    value("gamma"),  value("phi") + value("delta"),
          value("delta"), value("omega") + value("epsilon"), value("epsilon")};
}

/// How far [rad] a body that turned by Euler parameters p about z is from an angle.
template <class EulerParameters>
double apart_from_angle(const EulerParameters& p, double angle) {
  return std::abs(std::remainder(2 * std::atan2(p[3], p[0]) - angle, 2 * std::acos(-1.0)));
}

}  // namespace trivium
