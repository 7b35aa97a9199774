#pragma once
/// A table of text with aligned columns, which commands and validations print on a terminal. The tables of
/// the paper are made by paper/generator/tex.hpp.

#include <string>
#include <vector>

namespace trivium {

/// A table of text: the first column left-aligned, the others right-aligned.
class Table {
 public:
  explicit Table(std::vector<std::string> header) : rows_{std::move(header)} {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  /// The table as lines that end in '\n', with a rule under the header.
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace trivium
