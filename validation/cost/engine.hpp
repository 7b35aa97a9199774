#pragma once
/// The interface of an engine at one state of one scene. Every call of evaluate() computes the accelerations
/// anew. The file uses C++17 and standard types only, because some engines cannot be compiled together with
/// Trivium's headers.

#include <array>
#include <stdexcept>
#include <vector>

namespace trivium::cost {

using Vector3 = std::array<double, 3>;

/// The error of an engine that does not accept the scene, or would need too much time or memory. The message
/// says why.
class NotTaken : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Engine {
 public:
  virtual ~Engine() = default;

  /// Evaluates the accelerations; this call is timed.
  virtual void evaluate() = 0;

  /// The accelerations r'' [m/s^2] of the centres of mass of the last evaluation, global frame.
  virtual std::vector<Vector3> r_ddot() = 0;
  /// The multipliers of the last evaluation, one for each row of the scene; empty if the engine has none.
  virtual std::vector<double> lambda() { return {}; }
};

}  // namespace trivium::cost
