#pragma once
/// The formulations whose computing time is measured. r-epsilon-omega-first is left out: its equations of
/// motion are those of r-omega, and only its position coordinates differ.

#include "formulations/formulation_list.hpp"

namespace trivium {

using TimedFormulations = Formulations<ROmega, RP, REpsilon>;

}  // namespace trivium
