#include "validation/hard/announcement.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <limits>
#include <variant>

namespace trivium::hard {

double number_after(const std::string& text, std::string_view phrase) {
  double number = std::numeric_limits<double>::quiet_NaN();
  if (const std::size_t at = text.rfind(phrase); at != text.npos)
    std::from_chars(text.data() + at + phrase.size(), text.data() + text.size(), number);
  return number;
}

namespace {

/// Verbs with which advice begins, after a semicolon, a colon, a comma or "or".
constexpr std::array advising{"take",  "leave", "choose", "add",   "give",    "make", "use",    "remove",
                              "lower", "raise", "set",    "check", "correct", "try",  "switch", "move",
                              "solve", "start", "end",    "see",   "allow",   "hold", "change", "connect"};

bool advises(std::string message) {
  std::transform(message.begin(), message.end(), message.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  for (const char* verb : advising)
    for (const char* before : {"; ", ": ", ", ", ". ", "or ", "and "})
      if (const std::string advice = std::string(before) + verb + " ";
          message.find(advice) != std::string::npos)
        return true;
  return false;
}

/// Whether a name in quotes is that of a part of the scene, or of one of its rows ("hinge.x").
bool names_a_part(const std::string& message, const scenes::Scene& scene) {
  const auto is_named = [&](const std::string& name) {
    const std::size_t at = name.empty() ? message.npos : message.find('"' + name);
    if (at == message.npos) return false;
    const char after = message[at + 1 + name.size()];
    return after == '"' || after == '.' || after == '[';
  };
  const auto of = [&](const auto& parts) {
    return std::any_of(parts.begin(), parts.end(), [&](const auto& part) { return is_named(part.name); });
  };
  return of(scene.bodies) || of(scene.constraints) ||
         std::any_of(scene.effects.begin(), scene.effects.end(), [&](const scenes::Effect& effect) {
           return std::visit([&](const auto& one) { return is_named(one.name); }, effect);
         });
}

/// Whether a driver is said to demand what is said to be within reach.
bool contradicts_itself(const std::string& message) {
  const double demand = number_after(message, "demands f = "),
               value = number_after(message, "from its value "),
               most = number_after(message, "leave only values up to about "),
               least = number_after(message, "leave only values down to about ");
  return message.find("demands f = ") != message.npos && !(demand > most && value <= most) &&
         !(demand < least && value >= least);
}

}  // namespace

std::string missing_in_announcement(const std::string& message, std::optional<double> when,
                                    const scenes::Scene& scene, double start, double end,
                                    const std::string& reason) {
  if (!when) return "does not say when";
  if (!(*when >= start && *when <= end)) return "says when, but this is no time of the run";
  if (!names_a_part(message, scene)) return "does not say where";
  if (message.find(reason) == message.npos) return "does not say why, which is: " + reason;
  if (contradicts_itself(message)) return "demands what is within reach";
  if (!advises(message)) return "does not say what to try";
  return {};
}

}  // namespace trivium::hard
