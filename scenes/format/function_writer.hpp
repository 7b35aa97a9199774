#pragma once
/// From a function of time to JSON, as the scene format spells it ("Functions of time"). Its reading is in
/// function_reader.cpp.

#include "bodies/numbers/time_function.hpp"
#include "scenes/format/json.hpp"

namespace trivium::scenes {

Json to_json(const TimeFunction& f);

}  // namespace trivium::scenes
