#pragma once
/// Figures of the paper: lines over logarithmic axes, two side by side on a page. They are written as
/// pgfplots source from results files.

#include <string>
#include <utility>
#include <vector>

#include "paper/generator/tex.hpp"

namespace trivium::paper {

/// Lines in the order of the cycle list: four solid, then four dashed.
class LogLogFigure {
 public:
  LogLogFigure(Tex x_label, Tex y_label) : x_label_(std::move(x_label)), y_label_(std::move(y_label)) {}

  /// A point's coordinates as a results file has them. A line without points is left out.
  using Points = std::vector<std::pair<std::string, std::string>>;
  void add(const Tex& name, const Points& points);
  /// The picture, and a comment that says where it comes from.
  std::string str(const std::string& origin) const;

 private:
  Tex x_label_, y_label_;
  std::string lines_;
};

}  // namespace trivium::paper
