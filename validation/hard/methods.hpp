#pragma once
/// Which methods enter which family of hard cases, and why. The list exists once, in methods.cpp; `hard_cases
/// --list` prints it.

#include <string>
#include <vector>

namespace trivium::hard {

struct MethodsOfFamily {
  std::string family;
  std::vector<std::string> quick, whole;
  std::string why;  ///< these and no others
};

/// The list: one entry for a family of motions.
const std::vector<MethodsOfFamily>& method_list();

/// The methods of a family.
const std::vector<std::string>& methods_of(const std::string& family, bool quick);

}  // namespace trivium::hard
