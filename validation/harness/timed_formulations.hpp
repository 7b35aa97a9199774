#pragma once
/// The formulations whose cost is measured. r-epsilon-omega-first is not among them: its equations are those
/// of r-omega, and only its positions differ.

#include "formulations/formulation_list.hpp"

namespace trivium {

using TimedFormulations = Formulations<ROmega, RP, REpsilon>;

}  // namespace trivium
