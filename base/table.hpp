#pragma once
/// A table of text with aligned columns, which commands and validations print on a terminal. The tables of
/// the paper are made by paper/generator/tex.hpp.

#include <string>
#include <vector>

namespace trivium {

/// A table of text: the first column left-aligned, the others right-aligned.
class Table {
 public:
  /// The first column stands to the left, the others to the right, or the last to the left if it is `prose`.
  explicit Table(std::vector<std::string> header, bool prose = false)
      : rows_{std::move(header)}, prose_(prose) {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  /// The table as lines that end in '\n', with a rule under the header.
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
  bool prose_;
};

}  // namespace trivium
