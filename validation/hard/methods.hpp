#pragma once
/// Which methods enter which family of hard cases, and why. The list exists once, in methods.cpp; `hard_cases
/// --list` prints it.

#include <string>
#include <vector>

namespace trivium::hard {

struct MethodsOfFamily {
  std::string of;  ///< a family, a case that has methods of its own, or family/kind of its cases
  std::vector<std::string> quick, whole;
  std::string why;  ///< these and no others
};

/// All choices: of every family of motions, and of the cases that have their own.
const std::vector<MethodsOfFamily>& method_list();

/// Where no integrator of Simbody stands beside, and why.
struct WithoutSimbody {
  std::string of;  ///< a family or a case
  std::string why;
};
const std::vector<WithoutSimbody>& cases_without_simbody();

/// The methods of a family or a case.
const std::vector<std::string>& methods_of(const std::string& name, bool quick);

}  // namespace trivium::hard
