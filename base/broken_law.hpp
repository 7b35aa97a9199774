#pragma once
/// The report of one broken law. A concept of this library lists the members that a type must have; its laws
/// (constraint_laws.hpp, effect_laws.hpp and others) state how these members must behave. The law functions
/// return a list of `BrokenLaw`, so they need no test library.

#include <fmt/format.h>

#include <string>

namespace trivium {

/// A law that does not hold at the tested state, with the measured error and its tolerance.
struct BrokenLaw {
  std::string law;  ///< the law as a sentence
  double figure;    ///< measured error, relative to the size of the terms compared [-]
  double bound;     ///< largest error that rounding and difference quotients explain [-]

  std::string text() const { return fmt::format("{}: {:.1e}, bound {:.1e}", law, figure, bound); }
};

}  // namespace trivium
