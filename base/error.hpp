#pragma once
/// What goes wrong, as one type: a message that names the place, and a kind that says whose fault it is. A
/// program ends by the kind (base/command_line.hpp): input 2, all else 3.

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace trivium {

enum class ErrorKind {
  input,       ///< a file, an option or a request that cannot be
  model,       ///< the equations of motion cannot be formed or solved at this state
  integration  ///< a method in time gave up
};

class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}
  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

/// The equations of motion cannot be formed or solved at this state: which body, joint or effect, when, why,
/// and what to try.
class ModelError : public Error {
 public:
  explicit ModelError(const std::string& what) : Error(ErrorKind::model, what) {}
};

}  // namespace trivium
