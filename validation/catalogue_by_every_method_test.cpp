/// Every method runs the catalogue to the end in r-omega, r-p and r-epsilon, except in the cases of
/// docs/limits.md.

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "validation/testing/catalogue_motion.hpp"
#include "validation/testing/every_method.hpp"

namespace trivium {
namespace {

using test::catalogue_scene, test::Motion, test::stepping, test::tight;

/// The cosine driver of this scene passes a dead point at 0.25 s; docs/limits.md says which methods end
/// there with an error.
bool is_a_known_end(const std::string& scene, const Error& error) {
  return scene == "uwsbel_slider_crank" && error.when() && std::abs(*error.when() - 0.25) < 1e-3;
}

class CatalogueByEveryMethod : public testing::TestWithParam<integrators::MethodInfo> {};

TEST_P(CatalogueByEveryMethod, MovesInEveryFormulation) {
  const std::string method(GetParam().name);
  for (const auto& file : std::filesystem::directory_iterator(TRIVIUM_SCENES_DIR))
    for (const char* formulation : {"r-omega", "r-p", "r-epsilon"}) {
      const std::string scene = file.path().stem();
      if (file.path().extension() != ".json" || !goes_with(GetParam(), formulation)) continue;
      const SimulationOptions options = GetParam().chooses_steps ? tight(formulation, method, 0.3, 1e-6)
                                                                 : stepping(formulation, method, 0.3, 1e-4);
      try {
        EXPECT_TRUE(Motion(catalogue_scene(scene), options).report.complete);
      } catch (const Error& error) {
        EXPECT_TRUE(is_a_known_end(scene, error)) << scene << " " << formulation << ": " << error.what();
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, CatalogueByEveryMethod, testing::ValuesIn(integrators::methods()),
                         test::method_in_a_name);

}  // namespace
}  // namespace trivium
