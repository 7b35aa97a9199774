#include "base/error.hpp"

#include <fmt/format.h>

namespace trivium {

namespace {

std::string message(const Place& place, const char* why) {
  std::string before = place.where;
  if (place.when) before += fmt::format("{}at t = {}", before.empty() ? "" : " ", *place.when);
  return before.empty() ? why : fmt::format("{}: {}", before, why);
}

Place nearest(const Place& around, const Error& inner) {
  return {inner.where().empty() ? around.where : inner.where(), inner.when() ? inner.when() : around.when};
}

}  // namespace

std::string name_source(const std::string& source, std::string_view message) {
  const bool named =
      message == source || message.starts_with(source + " ") || message.starts_with(source + ":");
  return named ? std::string(message) : fmt::format("{}: {}", source, message);
}

Error::Error(const std::string& source, const Error& inner)
    : Error(inner.kind(), name_source(source, inner.what()),
            Place{inner.where().empty() ? source : name_source(source, inner.where()), inner.when()}) {}

Error::Error(ErrorKind kind, const Place& place, const std::string& why)
    : Error(kind, message(place, why.c_str()), place) {}

Error::Error(ErrorKind kind, const Place& around, const Error& inner)
    : Error(kind, message(around, inner.what()), nearest(around, inner)) {}

}  // namespace trivium
