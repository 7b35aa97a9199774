#pragma once
/// The motion against which others are judged: by a formula, or by a run of high order at tight tolerance.
/// Runs from neighbouring starts measure by how much the exact motion amplifies a difference of its start.

#include <functional>
#include <vector>

#include "mechanism/model.hpp"
#include "scenes/scene.hpp"
#include "simulation/simulate.hpp"

namespace trivium::hard {

/// Which difference of two motions is monitored [-].
enum class Monitor {
  motion,     ///< positions, orientations, velocities and angular velocities
  positions,  ///< of the centres of mass
};

/// The run that serves as exact motion: in double by a method of high order, for stiff scenes an implicit
/// one, or in quad.
enum class ReferenceRun { in_double, stiff, in_quad };

/// Sets poses and velocities at state.t.
using ExactState = std::function<void(MechanismState<double>&)>;

class ExactMotion {
 public:
  /// `outputs` states, evenly spread over (0, end].
  ExactMotion(const scenes::Scene& scene, double end, int outputs, Monitor monitor, const ExactState& exact,
              ReferenceRun reference);

  double output_step() const { return output_step_; }
  const std::vector<MechanismState<double>>& states() const { return states_; }
  /// By how much differences of the start have grown up to output k; at least 1.
  double amplification(std::size_t k) const { return amplification_[k]; }
  /// The difference of a state from that at output k: distances relative to the mechanism's extent, angles
  /// [rad], velocities relative to the largest ones of the motion.
  double difference(const MechanismState<double>& state, std::size_t k) const;

 private:
  double difference(const MechanismState<double>& a, const MechanismState<double>& b) const;
  void measure_amplification(const Model<double>& model);
  SimulationOptions options(double rtol) const;

  double end_, output_step_;
  Monitor monitor_;
  ReferenceRun reference_;
  double length_ = 1, speed_ = 1, rate_ = 1;
  std::vector<MechanismState<double>> states_;
  std::vector<double> amplification_;
};

}  // namespace trivium::hard
