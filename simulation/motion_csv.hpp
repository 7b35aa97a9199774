#pragma once
/// A motion as a CSV file, one line per output: t; per body r, p, r' and omega_bar (13 columns); per joint
/// the force and torque on body j; lambda; energy and the largest violations; then the method's raw lambda,
/// if it has one. Units and frames are those of MotionSample. Numbers are written with 17 digits, so that a
/// program that reads the file gets the same double.

#include <optional>
#include <string>
#include <vector>

#include "base/whole_file.hpp"
#include "mechanism/mechanism.hpp"
#include "simulation/motion.hpp"

namespace trivium {

/// The names of the columns. If not `has_raw_lambda`, the method's raw lambda is left out.
std::vector<std::string> motion_columns(const Mechanism<double>& mechanism, bool has_raw_lambda);
/// The numbers of one line, in the same order.
std::vector<double> motion_numbers(const MotionSample& sample, bool has_raw_lambda);

/// Writes a motion to a CSV file, line by line.
class MotionCsv {
 public:
  /// Opens a file beside `file`, which `keep` renames (GrowingFile). Throws std::filesystem::filesystem_error
  /// if `file` exists and is not a regular file.
  MotionCsv(const Mechanism<double>& mechanism, bool has_raw_lambda, const std::string& file);

  /// Adds a line. Returns false if this or an earlier line could not be written, as on a full disk.
  bool add(const MotionSample& sample);
  /// Replaces the file by the lines added so far. Throws std::runtime_error if that fails, or if a line could
  /// not be written; the message says where the written lines are.
  void keep();

 private:
  std::string name_;
  GrowingFile file_;
  bool has_raw_lambda_;
  /// Euler parameters of the last line. Of p and -p, the same orientation, the one nearer to these is
  /// written.
  std::vector<Vector4<double>> p_;
};

}  // namespace trivium
