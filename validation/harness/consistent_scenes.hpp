#pragma once
/// The scenes that a validation works on: named, or of the catalogue. All of them are read, and their states
/// found to satisfy the constraints, before any is computed: a run of hours does not end at its last scene.

#include <string>
#include <vector>

#include "base/error.hpp"
#include "scenes/catalogue.hpp"
#include "validation/harness/named_scene.hpp"

namespace trivium {

/// Scenes that cannot be read, or whose states do not satisfy their constraints: a message for each, one
/// line "error: ..." after the other where a program prints them.
class InputErrors : public Error {
 public:
  explicit InputErrors(const std::vector<std::string>& messages);
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
};

/// All of the scenes, whose states at time t must satisfy their constraints. Nothing can be computed and
/// lost: throws InputErrors about all that fail.
std::vector<NamedScene> load_consistent_scenes(const std::vector<std::string>& paths_or_names, double t);

}  // namespace trivium
