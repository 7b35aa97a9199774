#pragma once
/// The report of one broken law. A concept of this library lists the members that a type must have; its laws
/// (constraint_laws.hpp, effect_laws.hpp and others) state how these members must behave. The law functions
/// return a list of `BrokenLaw`, so they need no test library.

#include <fmt/format.h>

#include <string>

namespace trivium {

/// A law that does not hold at the tested state.
struct BrokenLaw {
  std::string law;       ///< the law as a sentence
  double figure, bound;  ///< measured relative error, and its tolerance for rounding and truncation [-]

  std::string text() const { return fmt::format("{}: {:.1e}, bound {:.1e}", law, figure, bound); }
};

}  // namespace trivium
