#pragma once
/// A table of text with aligned columns, which commands and validations print on a terminal. The tables of
/// the paper are made by paper/generator/tex.hpp.

#include <string>
#include <vector>

namespace trivium {

/// A table of text: the first column left-aligned, the others right-aligned, or the last one left-aligned
/// too.
class Table {
 public:
  /// `ends_in_prose`: the last column is left-aligned.
  explicit Table(std::vector<std::string> header, bool ends_in_prose = false)
      : rows_{std::move(header)}, ends_in_prose_(ends_in_prose) {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  /// The table as lines that end in '\n', with a rule under the header.
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
  bool ends_in_prose_;
};

}  // namespace trivium
