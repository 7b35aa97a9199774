#pragma once
/// An engine at one state of one scene: evaluates the accelerations as often as it is asked to, all of it
/// anew every time. C++17 and standard types only, because some engines cannot live beside our headers.

#include <array>
#include <stdexcept>
#include <vector>

namespace trivium::cost {

using Vector3 = std::array<double, 3>;

/// The engine does not take the scene, or would take too long or too much memory: why, in words.
class NotTaken : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Engine {
 public:
  virtual ~Engine() = default;

  /// What is timed.
  virtual void evaluate() = 0;

  /// Of the centres of mass, global, as last evaluated.
  virtual std::vector<Vector3> r_ddot() = 0;
  /// One multiplier per row of the scene, as last evaluated; empty where the engine has none.
  virtual std::vector<double> lambda() { return {}; }
};

}  // namespace trivium::cost
