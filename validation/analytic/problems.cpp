/// Puts the problems of all source files into one list. Problems with several scenes have one entry for each
/// scene.

#include "validation/analytic/problems.hpp"

#include <tuple>
#include <utility>

namespace trivium::analytic {

std::vector<Problem> problems() {
  std::vector<Problem> all{{"pendulum", pendulum},
                           {"heavy_top", heavy_top},
                           {"steady_precession", steady_precession},
                           {"four_bars", four_bars}};
  for (const auto& [problem, name, side] :
       {std::tuple("pendulum_on_a_revolute", "adams_revolute_case01", Vector(1, 0, 0)),
        {"pendulum_on_a_universal", "adams_universal_case01", Vector(0, 1, 0)}})
    all.push_back({problem, [name = name, side = side](const std::string& f, Errors& e) {
                     physical_pendulum(name, side, f, e);
                   }});
  for (const char* name : {"asymmetric_free_body", "dzhanibekov"})
    all.push_back({name, [name](const std::string& f, Errors& e) { free_body(name, f, e); }});
  for (const auto& [name, looser] : {std::pair("adams_revolute_case01", 1.0),
                                     {"adams_spherical_case02", 1.0},
                                     {"adams_universal_case01", 20.0}})
    all.push_back({name, [name = name, looser = looser](const std::string& f, Errors& e) {
                     adams(name, looser, f, e);
                   }});
  return all;
}

}  // namespace trivium::analytic
