#pragma once
/// The exception type of the library. An Error has a message, a kind and, where known, the place and the time
/// of the problem. The kind decides the exit code (base/command_line.hpp): 2 for input, else 3.

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace trivium {

/// What is wrong: the input, the model or the integration.
enum class ErrorKind {
  input,       ///< invalid file, option or request
  model,       ///< the equations of motion cannot be formed or solved at this state
  integration  ///< the integrator cannot continue
};

/// Where and when an error occurred.
struct Place {
  /// The part of the model, such as `body "rod"` or `row "hinge.cd(e_x)"`. For an invalid scene, also one
  /// built in C++, the JSON pointer to the faulty value, such as `/bodies/0/mass`. For an invalid setting of
  /// a run, the scene. May be empty.
  std::string where;
  std::optional<double> when = {};  ///< time of the state [s]
};

/// An error of the library: message, kind and place.
class Error : public std::runtime_error {
 public:
  /// Takes `what` as the complete message; place and time are not known.
  Error(ErrorKind kind, const std::string& what) : Error(kind, what, Place{}) {}
  /// Puts the place in front of the message: `body "rod" at t = 0.5: why`.
  Error(ErrorKind kind, const Place& place, const std::string& why);
  /// Takes `what` as the complete message.
  Error(ErrorKind kind, const std::string& what, const Place& place)
      : std::runtime_error(what), kind_(kind), place_(place) {}
  /// Puts `around` in front of the message of `inner`. The place and time of `inner` take precedence.
  Error(ErrorKind kind, const Place& around, const Error& inner);

  /// Puts the source of a scene in front of the message and of the place, unless they begin with it.
  Error(const std::string& source, const Error& inner);

  /// What is wrong: the input, the model or the integration.
  ErrorKind kind() const { return kind_; }
  /// The place of the problem (Place::where); may be empty.
  const std::string& where() const { return place_.where; }
  /// The time of the state at which the problem occurred [s]; none if it is not known.
  std::optional<double> when() const { return place_.when; }

 private:
  ErrorKind kind_;
  Place place_;
};

/// `source: message`, or `message` alone if it already begins with the source of the scene.
std::string name_source(const std::string& source, std::string_view message);

/// The equations of motion cannot be formed or solved at this state. The message names the body, joint or
/// effect, the time, the reason and a remedy.
class ModelError : public Error {
 public:
  /// Takes `what` as the complete message; place and time are not known.
  explicit ModelError(const std::string& what) : Error(ErrorKind::model, what) {}
  /// Puts the place in front of the message, as Error does.
  ModelError(const Place& place, const std::string& why) : Error(ErrorKind::model, place, why) {}
  /// Puts `around` in front of the message of `inner`. The place and time of `inner` take precedence.
  ModelError(const Place& around, const Error& inner) : Error(ErrorKind::model, around, inner) {}
};

}  // namespace trivium
