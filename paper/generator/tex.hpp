#pragma once
/// The little LaTeX that the generated files need: booktabs tables with siunitx columns, and named numbers.
/// What comes from a file is escaped.

#include <map>
#include <string>
#include <vector>

namespace trivium::paper {

/// LaTeX source, as it stands.
struct Tex {
  std::string source;
};

/// Text as LaTeX prints it: underscores and their like escaped.
Tex text(const std::string& plain);
Tex integer(std::size_t n);
/// Two digits and an exponent, which siunitx typesets; inside a paragraph it needs in_text().
Tex number(double x);
/// A results file's cell: a number to two digits, or text such as "none".
Tex number_or_text(const std::string& cell);
Tex in_text(double x);
/// A ratio: two digits or the integer, no exponent.
Tex ratio(double x);
Tex ratio_in_text(double x);
/// A bound that is a power of ten, without a mantissa.
Tex power_of_ten_in_text(double x);

struct TexColumn {
  std::string type;  ///< l, r, c, or S[...] of siunitx
  Tex heading;
};

/// A floating number column: d.d e +-dd.
inline const std::string scientific = "S[table-format=1.1e-2]";
/// The same for numbers of at least 1 and below 10^10.
inline const std::string condition = "S[table-format=1.1e1]";

class TexTable {
 public:
  explicit TexTable(std::vector<TexColumn> columns) : columns_(std::move(columns)) {}
  /// A line above the headings.
  void head(const Tex& line) { head_ += line.source + "\n"; }
  /// One cell a column; in S columns, what is no number is set as text.
  void add(const std::vector<Tex>& cells);
  void rule() { body_ += "\\midrule\n"; }
  /// The tabular, and a comment that says where it comes from.
  std::string str(const std::string& origin) const;

 private:
  std::string line(const std::vector<Tex>& cells) const;

  std::vector<TexColumn> columns_;
  std::string head_, body_;
};

/// The numbers in the running text: LaTeX commands, so that none is typed by hand.
class Numbers {
 public:
  /// \NAME; letters only, each name once.
  void define(const std::string& name, const Tex& value);
  std::string str() const;

 private:
  std::map<std::string, std::string> values_;
};

}  // namespace trivium::paper
