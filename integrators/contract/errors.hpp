#pragma once
/// How an integration ends where it cannot go on: a method gave up (exit code 3), or the request itself
/// cannot be met (exit code 2). Messages say at what time, why, and what to try.

#include <string>

#include "base/error.hpp"

namespace trivium::integrators {

/// A method gave up: says at what time, why, and what to try.
class IntegrationError : public Error {
 public:
  explicit IntegrationError(const std::string& what, ErrorKind kind = ErrorKind::integration)
      : Error(kind, what) {}
  IntegrationError(const Place& place, const std::string& why) : Error(ErrorKind::integration, place, why) {}
  /// `what` is all of the message.
  IntegrationError(const std::string& what, const Place& place)
      : Error(ErrorKind::integration, what, place) {}
};

/// What was asked for cannot be: times that do not fit together, a method with steps that it does not take.
class UsageError : public IntegrationError {
 public:
  explicit UsageError(const std::string& what) : IntegrationError(what, ErrorKind::input) {}
};

}  // namespace trivium::integrators
