#pragma once
/// The motion against which others are judged: by a formula, or by a run of high order at tight tolerance.
/// Runs from neighbouring starts measure by how much the exact motion amplifies a difference of its start.

#include <string>
#include <vector>

#include "mechanism/model.hpp"
#include "simulation/simulate.hpp"
#include "validation/hard/hard_motion.hpp"

namespace trivium::hard {

class ExactMotion {
 public:
  /// hard_outputs states, evenly spread over (start, end].
  explicit ExactMotion(const HardMotion& motion);

  /// Why the exact motion ends early; empty if it does not.
  const std::string& trouble() const { return trouble_; }
  /// Whether its run was given up because of its many steps; this is its trouble then.
  bool is_given_up() const { return is_given_up_; }
  /// The length to which differences are relative [m].
  double length() const { return length_; }
  /// The largest distance of a body from the global origin, relative to the length [-].
  double distance() const;
  /// The error that the tolerances of its own run allow, relative to the length; 0 if a formula is known [-].
  double tolerance() const { return tolerance_; }
  /// Whether runs from neighbouring starts have measured the amplification; else it is a lower bound.
  bool has_neighbours() const { return has_neighbours_; }
  double output_step() const { return output_step_; }
  const std::vector<MechanismState<double>>& states() const { return states_; }
  /// By how much differences of the start have grown up to output k; at least 1.
  double amplification(std::size_t k) const { return amplification_[k]; }
  /// Up to the last output; 1 if the motion ends early.
  double amplification() const { return amplification_.empty() ? 1 : amplification_.back(); }
  /// The difference of a state from that at output k: distances relative to the mechanism's extent, angles
  /// [rad], velocities relative to the largest ones of the motion.
  double difference(const MechanismState<double>& state, std::size_t k) const;
  /// The difference that a run's sums of local errors allow, in the same measure; a lower bound of it, as of
  /// angles only those of the body that errs most count.
  double difference(const LocalErrorSums& errors) const;
  /// The branch of the motion; its name is empty if there is only one.
  const Branch& branch() const { return motion_.branch; }
  /// The difference of velocities within a step of length `step` [s] by an error of positions [-].
  double of_velocities(double positions, double step) const;

 private:
  double difference(const MechanismState<double>& a, const MechanismState<double>& b) const;
  void measure_amplification(const Model<double>& model);
  SimulationOptions options(double rtol) const;

  HardMotion motion_;
  double output_step_;
  std::string trouble_;
  bool is_given_up_ = false;
  double length_ = 0, speed_ = 0, rate_ = 0, tolerance_ = 0;
  bool has_neighbours_ = false;
  std::vector<MechanismState<double>> states_;
  std::vector<double> amplification_;
  std::vector<double> reach_;  ///< of each body [m]
};

}  // namespace trivium::hard
