#pragma once
/// A motion as CSV, a line an output: t, then of every body its place, Euler parameters, velocity and
/// body-frame angular velocity, of every joint its reaction on body j, lambda, energy and the largest
/// violations; then the method's own lambda, if it has any. Numbers have all digits of a double.

#include <optional>
#include <string>
#include <vector>

#include "base/whole_file.hpp"
#include "mechanism/mechanism.hpp"
#include "simulation/motion.hpp"

namespace trivium {

/// What a line of it holds: names, and the numbers of an output. Without `has_raw_lambda` the method's own
/// lambda is left out.
std::vector<std::string> motion_columns(const Mechanism<double>& mechanism, bool has_raw_lambda);
std::vector<double> motion_numbers(const MotionSample& sample, bool has_raw_lambda);

class MotionCsv {
 public:
  /// The file stays as it was until `keep`.
  MotionCsv(const Mechanism<double>& mechanism, bool has_raw_lambda, const std::string& file);

  void add(const MotionSample& sample);
  /// Throws std::filesystem::filesystem_error.
  void keep();

 private:
  std::string name_;
  GrowingFile file_;
  bool has_raw_lambda_;
  std::vector<Vector4<double>>
      p_;  ///< as written last: p and -p are one orientation, and one of them is near
};

}  // namespace trivium
