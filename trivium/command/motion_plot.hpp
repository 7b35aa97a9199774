#pragma once
/// A figure of a motion with three panels: positions of bodies, joint forces, and violations of constraints
/// with the change of energy. gnuplot draws it from the samples of a run.

#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "simulation/motion.hpp"

namespace trivium {

class MotionPlot {
 public:
  MotionPlot(const Mechanism<double>& mechanism, std::string title);

  void add(const MotionSample& sample);
  /// Writes an SVG file, if there are two samples. Throws a std::runtime_error without a working gnuplot.
  void write(const std::string& file) const;

 private:
  /// The indices of the bodies or joints in the figure: the first three and the last.
  static std::vector<std::size_t> shown(std::size_t count);

  std::string title_;
  std::vector<std::string> bodies_, joints_;
  std::vector<std::size_t> shown_bodies_, shown_joints_;
  /// One line per sample: t, r of the shown bodies, |force| of the shown joints, |E - E(0)|, phi, phi_dot.
  std::string data_;
  double first_energy_ = 0;
  int samples_ = 0;
};

}  // namespace trivium
