#pragma once
/// Loads the scenes of a validation program and checks their states against their constraints. Programs call
/// this before the first computation, so that a wrong scene is reported at once and not after hours.

#include <string>
#include <vector>

#include "base/error.hpp"
#include "scenes/catalogue.hpp"
#include "validation/harness/named_scene.hpp"

namespace trivium {

/// The error for scenes that cannot be read or whose states violate their constraints. It holds one message
/// for each scene; programs print each message as a line "error: ...".
class InputErrors : public Error {
 public:
  explicit InputErrors(const std::vector<std::string>& messages);
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
};

/// Loads all scenes. Throws InputErrors with a message for every scene that cannot be read, or whose state at
/// time t violates its constraints.
std::vector<NamedScene> load_consistent_scenes(const std::vector<std::string>& paths_or_names, double t);

}  // namespace trivium
