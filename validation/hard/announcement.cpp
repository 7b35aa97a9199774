#include "validation/hard/announcement.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace trivium::hard {

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

}  // namespace

std::string missing_in_announcement(const std::string& message, std::optional<double> when) {
  if (!when && message.find("t = ") == message.npos) return "does not say when";
  if (std::count(message.begin(), message.end(), '"') < 2) return "does not say where";
  if (!advises(message)) return "does not say what to try";
  return {};
}

}  // namespace trivium::hard
