#pragma once
/// What goes wrong, as one type: a message, a kind that says whose fault it is, and the place and the time
/// where they are known. A program ends by the kind (base/command_line.hpp): input 2, all else 3.

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace trivium {

enum class ErrorKind {
  input,       ///< a file, an option or a request that cannot be
  model,       ///< the equations of motion cannot be formed or solved at this state
  integration  ///< a method in time gave up
};

/// Where something went wrong: `body "rod"`, `row "hinge.cd(x)"`, a file with the place in it; empty where it
/// is of no one place. When: the time of the state [s].
struct Place {
  std::string where;
  std::optional<double> when = {};
};

class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& what) : Error(kind, what, Place{}) {}
  /// The message begins with the place: `body "rod" at t = 0.5: why`.
  Error(ErrorKind kind, const Place& place, const std::string& why);
  /// `what` is all of the message.
  Error(ErrorKind kind, const std::string& what, const Place& place)
      : std::runtime_error(what), kind_(kind), place_(place) {}
  /// The message of another, with what is around it in front; the place is the inner one, where it has one.
  Error(ErrorKind kind, const Place& around, const Error& inner);

  /// The same, of a scene: its source is put in front of a message that does not begin with it, and of the
  /// place.
  Error(const std::string& source, const Error& inner);

  ErrorKind kind() const { return kind_; }
  const std::string& where() const { return place_.where; }
  std::optional<double> when() const { return place_.when; }

 private:
  ErrorKind kind_;
  Place place_;
};

/// A message with the source of its scene in front, unless it begins with it.
std::string name_source(const std::string& source, std::string_view message);

/// The equations of motion cannot be formed or solved at this state: which body, joint or effect, when, why,
/// and what to try.
class ModelError : public Error {
 public:
  explicit ModelError(const std::string& what) : Error(ErrorKind::model, what) {}
  ModelError(const Place& place, const std::string& why) : Error(ErrorKind::model, place, why) {}
  ModelError(const Place& around, const Error& inner) : Error(ErrorKind::model, around, inner) {}
};

}  // namespace trivium
