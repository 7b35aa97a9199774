#include "validation/hard/fault_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "scenes/building.hpp"
#include "validation/hard/factors.hpp"

namespace trivium::hard {

using building::body, building::gravity, building::joint, building::side;
using scenes::ground, scenes::Scene, scenes::Vector3;

Options operator+(Options all, const Options& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

Row row_of_end(const Judge& judge, const std::string& formulation, const std::string& method) {
  return judge.row(formulation, method, "exit code and files [wrong runs]");
}

void settle(Judge& judge, Row row, bool announced, std::vector<std::string> wrong, const std::string& why) {
  std::erase(wrong, "");
  row.value = static_cast<double>(wrong.size());
  row.threshold = factors::wrong_runs;
  row.verdict = !row.is_met() ? Verdict::fails : announced ? Verdict::announces : Verdict::survives;
  row.why = (wrong.empty() ? "" : wrong.front() + (why.empty() ? "" : "; ")) + why;
  row.why = std::regex_replace(row.why, std::regex("incomplete-[0-9]+"), "incomplete-N");
  std::replace(row.why.begin(), row.why.end(), '\n', ' ');
  judge.add(row);
}

Scene pushed_pendulum(double c) {
  const TimeFunction line = TimeFunction::Polynomial{{0, c}},
                     push = TimeFunction::Product{{line, line, line, line}};
  Scene scene;
  scene.name = fmt::format("pushed_pendulum_{:g}", c);
  scene.bodies = {body("rod", 1, {0.1, 0.2, 0.3}, {1, 0, 0})};
  scene.constraints = {joint(JointType::revolute, "hinge", side(ground, Vector3{}, Vector3{0, 1, 0}),
                             side(0, Vector3{-1, 0, 0}, Vector3{0, 1, 0}))};
  Force<double> force;
  force.name = "push";
  force.components[2] = TimeFunction::Piecewise{{onset}, {TimeFunction(0), push}};
  scene.effects = {gravity(), force};
  return scene;
}

}  // namespace trivium::hard
