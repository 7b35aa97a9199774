#pragma once
/// Loads the scenes that a validation program works on: the named scenes, or the catalogue. All scenes are
/// read and their states checked before the first computation, so that a run of hours cannot fail at its last
/// scene.

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
