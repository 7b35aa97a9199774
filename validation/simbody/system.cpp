/// Builds the Simbody model: mobilizers first, then the constraints of the remaining joints, forces, and the
/// state that fits the mobilizers to the poses and velocities of the scene.

#include "validation/simbody/system.hpp"

#include <cctype>

#include "validation/simbody/forces.hpp"

namespace trivium::simbody {

System::System(const Model& of, Way way)
    : model(of), matter(multibody), forces(multibody), bodies{matter, {}} {
  matter.setShowDefaultGeometry(false);
  tree = spanning_tree(model, way == Way::mobilizers);
  bodies.index.resize(model.bodies.size());
  branch_of_joint.assign(model.joints.size(), nullptr);
  for (const Branch& branch : tree) {
    bodies.index[static_cast<std::size_t>(branch.body)] = add_mobilizer(model, branch, bodies);
    if (branch.joint != Branch::none) branch_of_joint[static_cast<std::size_t>(branch.joint)] = &branch;
  }
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    if (branch_of_joint[k]) continue;
    const auto add = way == Way::built_in ? add_built_in_rows : add_custom_rows;
    add(model, static_cast<int>(k), bodies, constraints);
  }
  add_effects(model, tree, bodies, forces);
  state = multibody.realizeTopology();
  multibody.realizeModel(state);
  state.updTime() = model.t;
  for (const Branch& branch : tree) fit_mobilizer(model, branch, bodies, state);
  if (way == Way::mobilizers) disable_idle_rows();
  multibody.realize(state, SimTK::Stage::Acceleration);
}

void System::disable_idle_rows() {
  multibody.realize(state, SimTK::Stage::Velocity);
  std::vector<LinkedConstraint> active, idle;
  for (const LinkedConstraint& c : constraints)
    (is_idle(matter, matter.getConstraint(c.index), state) ? idle : active).push_back(c);
  for (const LinkedConstraint& c : idle) {
    matter.getConstraint(c.index).disable(state);
    idle_rows.push_back(c.rows.front().row);
  }
  constraints = active;
}

std::string on_one_line(const std::string& message) {
  std::string line;
  for (const char c : message) {
    const char printable = std::isspace(static_cast<unsigned char>(c)) ? ' ' : c;
    if (printable != ' ' || (!line.empty() && line.back() != ' ')) line += printable;
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  const std::string prefix = "SimTK Exception thrown at ";
  const std::size_t end = line.rfind(prefix, 0) == 0 ? line.find(": ") : std::string::npos;
  return end == std::string::npos ? line : line.substr(end + 2);
}

std::vector<int> mobilizers(const Model& model, Way way) {
  std::vector<int> joints;
  for (const Branch& branch : spanning_tree(model, way == Way::mobilizers))
    if (branch.joint != Branch::none) joints.push_back(branch.joint);
  return joints;
}

}  // namespace trivium::simbody
