#pragma once
/// Writes a function of time as JSON, in the spelling of the scene format ("Functions of time"). The reader
/// of such functions is function_reader.cpp.

#include "bodies/numbers/time_function.hpp"
#include "scenes/format/json.hpp"

namespace trivium::scenes {

/// The JSON value of a function of time.
Json to_json(const TimeFunction& f);

}  // namespace trivium::scenes
