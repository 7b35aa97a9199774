#pragma once
/// Median (of an even count the upper of the two middle values), smallest and largest value of a column of
/// numbers. The name of the row with the largest value is kept, so that the text can quote it.

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace trivium::paper {

/// Numbers, each with a name, such as the name of its scene.
class Sample {
 public:
  void add(double value, const std::string& name = "") { values_.push_back({value, name}); }
  std::size_t size() const { return values_.size(); }
  double median() const { return sorted()[values_.size() / 2].value; }
  double worst() const { return sorted().back().value; }
  double least() const { return sorted().front().value; }
  std::string worst_name() const { return sorted().back().name; }

 private:
  struct Named {
    double value;
    std::string name;
  };
  std::vector<Named> sorted() const {
    if (values_.empty()) throw std::logic_error("statistics of an empty list of numbers");
    std::vector<Named> out = values_;
    std::stable_sort(out.begin(), out.end(),
                     [](const Named& a, const Named& b) { return a.value < b.value; });
    return out;
  }
  std::vector<Named> values_;
};

}  // namespace trivium::paper
