#pragma once
/// A row of hard_cases: one case in one formulation by one method, with what is monitored, how large it may
/// be, and the verdict.

#include <string>

namespace trivium::hard {

enum class Verdict {
  survives,    ///< the error is below its threshold, and an easy twin is not warned of either
  announces,   ///< the error is larger, and an error or a warning says so
  not_judged,  ///< the tolerance promises nothing, from the first compared state on
  fails        ///< the error is larger, and nothing says so
};

struct Row {
  std::string family, name, formulation, method;
  std::string quantity;      ///< what is monitored, with its unit
  double value = 0;          ///< its error; NaN if the case ended early or is not judged
  double tolerance = 0;      ///< the error that is asked for, before it is amplified
  double amplification = 1;  ///< by how much the exact motion or the state amplifies it
  double threshold = 0;      ///< factor . tolerance . amplification; of a motion at most small_difference
  Verdict verdict = Verdict::survives;
  std::string why;       ///< one line
  bool counts = true;    ///< false for other engines, which stand beside
  bool is_twin = false;  ///< the easy twin, which must survive without a warning

  bool is_met() const { return value <= threshold; }
};

/// Of rows of one kind: the worse verdict, then the larger value.
inline bool is_worse(const Row& a, const Row& b) {
  return a.verdict != b.verdict ? a.verdict > b.verdict : a.value > b.value;
}

inline const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::survives:
      return "survives";
    case Verdict::announces:
      return "announces";
    case Verdict::not_judged:
      return "not judged";
    case Verdict::fails:
      break;
  }
  return "FAILS";
}

/// Its verdict as text; in brackets if it does not count.
inline std::string verdict_of(const Row& row) {
  return row.counts ? name_of(row.verdict) : '(' + std::string(name_of(row.verdict)) + ')';
}

}  // namespace trivium::hard
