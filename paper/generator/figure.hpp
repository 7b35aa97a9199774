#pragma once
/// Figures of the paper: lines over logarithmic axes, two figures side by side on a page. They are written as
/// pgfplots source from results files.

#include <string>
#include <utility>
#include <vector>

#include "paper/generator/tex.hpp"

namespace trivium::paper {

/// A figure with up to eight lines. The cycle list draws the first four solid and the next four dashed.
class LogLogFigure {
 public:
  LogLogFigure(Tex x_label, Tex y_label) : x_label_(std::move(x_label)), y_label_(std::move(y_label)) {}

  /// The coordinates of the points, as text from a results file. A line without points is omitted.
  using Points = std::vector<std::pair<std::string, std::string>>;
  void add(const Tex& name, const Points& points);
  /// The LaTeX source of the figure, with a comment that names the results file.
  std::string str(const std::string& origin) const;

 private:
  Tex x_label_, y_label_;
  std::string lines_;
};

}  // namespace trivium::paper
