#pragma once
/// What goes wrong inside a model: a message that says which body, joint or effect, when, why, and what to
/// try.

#include <fmt/format.h>

#include <stdexcept>

namespace trivium {

/// The equations of motion cannot be formed or solved at this state.
class ModelError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace trivium
