#pragma once
/// The parts of LaTeX that the generated files need: booktabs tables with siunitx columns, and named numbers.
/// Text from results files is escaped.

#include <map>
#include <string>
#include <vector>

namespace trivium::paper {

/// LaTeX source that is printed unchanged.
struct Tex {
  std::string source;
};

/// Plain text as LaTeX source: underscores and other special characters are escaped.
Tex text(const std::string& plain);
Tex integer(std::size_t n);
/// Two digits and an exponent for an S column of siunitx. In running text use in_text() instead.
Tex number(double x);
/// The cell of a results file: a number with two digits, or a text such as "none".
Tex number_or_text(const std::string& cell);
Tex in_text(double x);
/// A ratio with two significant digits, or all digits of its integer part, without an exponent.
Tex ratio(double x);
Tex ratio_in_text(double x);
/// A power of ten without a mantissa.
Tex power_of_ten_in_text(double x);

struct TexColumn {
  std::string type;  ///< l, r, c, or S[...] of siunitx
  Tex heading;
};

/// The type of a column of numbers with two digits and an exponent of at most two digits and a sign.
inline const std::string scientific = "S[table-format=1.1e-2]";
/// The type of a column of numbers from 1 to below 10^10.
inline const std::string condition = "S[table-format=1.1e1]";

class TexTable {
 public:
  explicit TexTable(std::vector<TexColumn> columns) : columns_(std::move(columns)) {}
  /// Adds a line above the headings.
  void head(const Tex& line) { head_ += line.source + "\n"; }
  /// Adds a row with one cell for each column. In S columns, a cell that is not a number is set as text.
  void add(const std::vector<Tex>& cells);
  void rule() { body_ += "\\midrule\n"; }
  /// The tabular, with a comment that names the results file.
  std::string str(const std::string& origin) const;

 private:
  std::string line(const std::vector<Tex>& cells) const;

  std::vector<TexColumn> columns_;
  std::string head_, body_;
};

/// The numbers in the running text, as LaTeX commands: no number in the text is typed by hand.
class Numbers {
 public:
  /// Defines the LaTeX command called `name`. Throws std::logic_error unless the name is new and consists of
  /// letters.
  void define(const std::string& name, const Tex& value);
  std::string str() const;

 private:
  std::map<std::string, std::string> values_;
};

}  // namespace trivium::paper
