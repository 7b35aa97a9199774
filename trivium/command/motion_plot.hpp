#pragma once
/// A motion as a figure: where the bodies are, what the joints carry, and how well constraints and energy
/// hold. Drawn by gnuplot from the samples of a run.

#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "simulation/motion.hpp"

namespace trivium {

class MotionPlot {
 public:
  MotionPlot(const Mechanism<double>& mechanism, std::string title);

  void add(const MotionSample& sample);
  /// SVG; nothing where there are no two samples. Throws a std::runtime_error where gnuplot is not there or
  /// fails.
  void write(const std::string& file) const;

 private:
  /// The first few; the last one is always shown.
  static std::vector<std::size_t> shown(std::size_t count);

  std::string title_;
  std::vector<std::string> bodies_, joints_;
  std::vector<std::size_t> shown_bodies_, shown_joints_;
  std::string
      data_;  ///< a line a sample: t, x y z of the bodies, |force| of the joints, energy, phi, phi_dot
  double first_energy_ = 0;
  int samples_ = 0;
};

}  // namespace trivium
