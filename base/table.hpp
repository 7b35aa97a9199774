#pragma once
/// A table of text with aligned columns, as the commands and validations print it on a terminal. Tables of
/// the paper are paper/generator/tex.hpp's.

#include <string>
#include <vector>

namespace trivium {

/// A table of text: the first column left-aligned, the others right-aligned.
class Table {
 public:
  explicit Table(std::vector<std::string> header) : rows_{std::move(header)} {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  /// Lines ending in '\n', a rule under the header.
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace trivium
