#pragma once
/// Trusted numbers (validation/reference/*.csv; each says where it comes from). A support of the tests.

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace trivium::test {

/// A table of numbers by column; a first column of names is `name`.
struct Reference {
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> columns;

  explicit Reference(const std::string& name) {
    std::ifstream file(std::string(TRIVIUM_REFERENCE_DIR) + "/" + name + ".csv");
    if (!file) throw std::runtime_error("no reference " + name);
    std::vector<std::string> header;
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with('#')) continue;
      std::istringstream fields(line);
      std::vector<std::string> cells;
      for (std::string cell; std::getline(fields, cell, ',');) cells.push_back(cell);
      if (header.empty()) {
        header = cells;
        continue;
      }
      for (std::size_t k = 0; k < header.size(); ++k)
        if (header[k] == "name")
          names.push_back(cells[k]);
        else
          columns[header[k]].push_back(std::stod(cells[k]));
    }
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

}  // namespace trivium::test
