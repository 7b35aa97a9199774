#pragma once
/// The errors of an integration. Either a method fails (exit code 3), or the request cannot be fulfilled
/// (exit code 2).

#include <string>
#include <string_view>

#include "base/error.hpp"

namespace trivium::integrators {

/// A method failed. The message says when, why, and which change may help, such as smaller steps.
class IntegrationError : public Error {
 public:
  explicit IntegrationError(const std::string& what, ErrorKind kind = ErrorKind::integration)
      : Error(kind, what) {}
  IntegrationError(const Place& place, const std::string& why) : Error(ErrorKind::integration, place, why) {}
  /// `what` is the complete message; the place is not put in front of it.
  IntegrationError(const std::string& what, const Place& place)
      : Error(ErrorKind::integration, what, place) {}
};

/// The message without advice on steps or tolerances at its end, which does not help if the cause is another.
inline std::string without_advice(std::string message) {
  const std::size_t end = message.rfind("; ");
  if (end == std::string::npos) return message;
  const std::string_view advice = std::string_view(message).substr(end + 2);
  if (advice.starts_with("take smaller steps") || advice.starts_with("try other tolerances"))
    message.resize(end);
  return message;
}

/// A request that cannot be fulfilled, such as times that contradict each other or a method with steps of a
/// kind that it does not take.
class UsageError : public IntegrationError {
 public:
  explicit UsageError(const std::string& what) : IntegrationError(what, ErrorKind::input) {}
};

}  // namespace trivium::integrators
