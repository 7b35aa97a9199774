/// Finds the folder of the reference tables: $TRIVIUM_REFERENCE, then the installation of the catalogue, then
/// the source tree.

#include "validation/harness/trusted_numbers.hpp"

#include <cstdlib>

#include "scenes/catalogue.hpp"

namespace trivium {

std::string reference_directory() {
  if (const char* from_environment = std::getenv("TRIVIUM_REFERENCE")) return from_environment;
  const std::filesystem::path installed = catalogue_directory().parent_path() / "reference";
  return std::filesystem::is_directory(installed) ? installed.string() : TRIVIUM_SOURCE_REFERENCE;
}

}  // namespace trivium
