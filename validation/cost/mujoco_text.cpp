/// Writes bodies depth first, the order in which MuJoCo numbers them, and splits deep trees into several
/// files.

#include "validation/cost/mujoco_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <optional>

namespace trivium::cost {

namespace {

/// Largest number of nested bodies in one file. tinyxml2, which parses MuJoCo's files, accepts 100 nested
/// elements; 80 leaves room for the elements around and in the bodies. A deeper tree continues in an included
/// file.
constexpr int most_nested = 80;

template <class Numbers>
std::string list(const Numbers& numbers) {
  return fmt::format("{}", fmt::join(numbers, " "));
}

/// Visits the tree depth first, the order in which MuJoCo numbers the bodies. `enter` and `leave` get each
/// body and its depth. The walk uses an explicit stack, because long chains are too deep for recursion.
class DepthFirst {
 public:
  explicit DepthFirst(const PeerScene& scene) : scene_(scene), children_(scene.tree.size() + 1) {
    std::vector<std::size_t> place(scene.tree.size());
    for (std::size_t k = 0; k < scene.tree.size(); ++k) {
      const TreeJoint& branch = scene.tree[k];
      place[static_cast<std::size_t>(branch.body)] = k;
      children_[branch.parent == ground ? scene.tree.size() : place[static_cast<std::size_t>(branch.parent)]]
          .push_back(k);
    }
  }

  template <class Enter, class Leave>
  void walk(const Enter& enter, const Leave& leave) const {
    struct Visit {
      std::size_t branch, next_child;
    };
    std::vector<Visit> path{{scene_.tree.size(), 0}};
    while (!path.empty()) {
      Visit& at = path.back();
      if (at.next_child < children_[at.branch].size()) {
        const std::size_t child = children_[at.branch][at.next_child++];
        enter(scene_.tree[child], static_cast<int>(path.size()));
        path.push_back({child, 0});
      } else {
        const std::size_t done = at.branch;
        path.pop_back();
        if (!path.empty()) leave(scene_.tree[done], static_cast<int>(path.size()));
      }
    }
  }

 private:
  const PeerScene& scene_;
  std::vector<std::vector<std::size_t>> children_;  ///< of each branch; the last entry is the ground's
};

std::string inertial(const simbody::Body& body) {
  const simbody::Matrix3& J = body.inertia;
  const bool is_diagonal = J[0][1] == 0 && J[0][2] == 0 && J[1][2] == 0;
  const std::string inertia = is_diagonal ? fmt::format("diaginertia=\"{} {} {}\"", J[0][0], J[1][1], J[2][2])
                                          : fmt::format("fullinertia=\"{} {} {} {} {} {}\"", J[0][0], J[1][1],
                                                        J[2][2], J[0][1], J[0][2], J[1][2]);
  return fmt::format("<inertial pos=\"0 0 0\" mass=\"{}\" {}/>", body.mass, inertia);
}

std::string joints(const TreeJoint& branch) {
  if (branch.kind == TreeJoint::Kind::free) return "<freejoint/>";
  const std::string point = list(branch.point);
  if (branch.kind == TreeJoint::Kind::ball) return fmt::format("<joint type=\"ball\" pos=\"{}\"/>", point);
  std::string out;
  for (const TreeJoint::Axis& axis : branch.axes)
    out += fmt::format("<joint type=\"{}\" pos=\"{}\" axis=\"{}\"/>", axis.slides ? "slide" : "hinge", point,
                       list(axis.direction));
  return out;
}

/// A constraint that fixes one point of the first body to the second body: the joint's point, or with
/// `beside` the point 1 m along the joint's axis. The two points together hold the axis of a revolute joint.
/// MuJoCo's constraints are soft. 0.9999 is the largest impedance that MuJoCo accepts, and gives the stiffest
/// constraint; the width 0.001 has no effect, because the first two numbers are equal.
std::string connect(const simbody::Joint& joint, bool beside) {
  const bool turned = joint.i == ground;
  const int first = turned ? joint.j : joint.i, second = turned ? joint.i : joint.j;
  const simbody::JointFrame& frame = turned ? joint.frame_j : joint.frame_i;
  Vector3 anchor = frame.point;
  for (std::size_t k = 0; k < 3 && beside; ++k) anchor[k] += frame.z[k];
  const std::string other = second == ground ? "" : fmt::format(" body2=\"b{}\"", second);
  return fmt::format("<connect body1=\"b{}\"{} anchor=\"{}\" solimp=\"0.9999 0.9999 0.001\"/>\n", first,
                     other, list(anchor));
}

std::string closing(const PeerScene& scene, const simbody::Joint& joint) {
  if (joint.type == simbody::JointType::spherical) return connect(joint, false);
  if (joint.type == simbody::JointType::revolute)
    return connect(joint, false) + (scene.is_planar ? std::string() : connect(joint, true));
  throw NotTaken(fmt::format("no equality constraint for the closing joint {}", joint.name));
}

}  // namespace

std::vector<TextFile> mujoco_files(const PeerScene& scene) {
  // a body whose depth is a multiple of most_nested starts a new file
  std::vector<TextFile> done, open{{"model.xml", ""}};
  int included = 0;
  DepthFirst(scene).walk(
      [&](const TreeJoint& branch, int depth) {
        if (depth % most_nested == 0) {
          const std::string name = fmt::format("part_{}.xml", ++included);
          open.back().text += fmt::format("<include file=\"{}\"/>\n", name);
          open.push_back({name, "<mujocoinclude>\n"});
        }
        open.back().text +=
            fmt::format("<body name=\"b{}\" pos=\"{}\" quat=\"{}\">{}{}\n", branch.body,
                        list(branch.position), list(branch.orientation),
                        inertial(scene.model.bodies[static_cast<std::size_t>(branch.body)]), joints(branch));
      },
      [&](const TreeJoint&, int depth) {
        open.back().text += "</body>\n";
        if (depth % most_nested == 0) {
          open.back().text += "</mujocoinclude>\n";
          done.push_back(std::move(open.back()));
          open.pop_back();
        }
      });
  std::string equalities;
  for (const int k : scene.closings)
    equalities += closing(scene, scene.model.joints[static_cast<std::size_t>(k)]);
  TextFile& model = open.front();
  model.text = fmt::format(
      "<mujoco>\n<compiler angle=\"radian\" inertiafromgeom=\"false\" boundmass=\"0\" boundinertia=\"0\"/>\n"
      "<option gravity=\"{}\"><flag contact=\"disable\" passive=\"disable\" limit=\"disable\" "
      "frictionloss=\"disable\" actuation=\"disable\" sensor=\"disable\" warmstart=\"disable\"/></option>\n"
      "<size njmax=\"{}\" "
      "nconmax=\"1\"/>\n<worldbody>\n{}</worldbody>\n<equality>\n{}</equality>\n</mujoco>\n",
      list(scene.gravity), 6 * scene.closings.size() + 1, model.text, equalities);
  done.insert(done.begin(), std::move(model));
  return done;
}

std::vector<double> mujoco_velocities(const PeerScene& scene) {
  std::vector<double> rates;
  DepthFirst(scene).walk(
      [&](const TreeJoint& branch, int) {
        if (branch.kind == TreeJoint::Kind::free)
          rates.insert(rates.end(), branch.velocity.begin(), branch.velocity.end());
        if (branch.kind != TreeJoint::Kind::axes)
          rates.insert(rates.end(), branch.angular_velocity.begin(), branch.angular_velocity.end());
        for (const TreeJoint::Axis& axis : branch.axes) rates.push_back(axis.rate);
      },
      [](const TreeJoint&, int) {});
  return rates;
}

}  // namespace trivium::cost
