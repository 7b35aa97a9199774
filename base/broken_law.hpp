#pragma once
/// A law of a contract that does not hold, as the law functions report it: contracts say what types must
/// have, and their laws say how it must behave. No test library is needed to try them.

#include <fmt/format.h>

#include <string>

namespace trivium {

/// By how much, beside what rounding explains.
struct BrokenLaw {
  std::string law;
  double figure, bound;

  std::string text() const { return fmt::format("{}: {:.1e}, bound {:.1e}", law, figure, bound); }
};

}  // namespace trivium
