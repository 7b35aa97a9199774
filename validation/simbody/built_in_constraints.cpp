/// Adds the rows of a joint as Simbody's own constraints (declared in rows.hpp).

#include <cmath>

#include "validation/simbody/rows.hpp"

namespace trivium::simbody {

namespace {

using SimTK::Constraint;
using SimTK::Transform;
using SimTK::UnitVec3;
using SimTK::Vec3;

/// Adds Simbody's constraints for the rows of one joint.
class BuiltInRows {
 public:
  BuiltInRows(const Model& model, int joint, const BodyMap& bodies, std::vector<LinkedConstraint>& out)
      : model_(model),
        index_(joint),
        joint_(model.joints[static_cast<std::size_t>(joint)]),
        bodies_(bodies),
        out_(out) {}

  void add() {
    const int first = joint_.first_row;
    switch (joint_.type) {
      case JointType::spherical:
        return ball(first);
      case JointType::universal:
        ball(first);
        return single(first + 3);
      case JointType::revolute:
        ball(first);
        single(first + 3);
        return single(first + 4);
      case JointType::fixed:
        return weld(first);
      case JointType::translational:
        same_orientation(first, first + 1, first + 4);
        single(first + 2);
        return single(first + 3);
      case JointType::cylindrical:
      case JointType::planar:
      case JointType::other:
        for (int row = first; row < first + joint_.rows; ++row) single(row);
    }
  }

 private:
  void link(const Constraint& constraint, std::vector<RowLink> rows) {
    out_.push_back({constraint.getConstraintIndex(), index_, std::move(rows)});
  }
  SimTK::MobilizedBody& i() const { return bodies_[joint_.i]; }
  SimTK::MobilizedBody& j() const { return bodies_[joint_.j]; }
  static SimTK::Rotation axes(const JointFrame& f) {
    return SimTK::Rotation(SimTK::Mat33(vec(f.u), vec(f.v), vec(f.z)), true);
  }

  void ball(int row) {
    const Constraint::Ball c(i(), vec(joint_.frame_i.point), j(), vec(joint_.frame_j.point));
    link(c, {{row, 1.0}, {row + 1, 1.0}, {row + 2, 1.0}});
  }
  void weld(int row) {
    const Constraint::Weld c(i(), Transform(axes(joint_.frame_i), vec(joint_.frame_i.point)), j(),
                             Transform(axes(joint_.frame_j), vec(joint_.frame_j.point)));
    link(c, {{row + 5, -1.0}, {row + 4, -1.0}, {row + 3, 1.0}, {row, 1.0}, {row + 1, 1.0}, {row + 2, 1.0}});
  }
  void same_orientation(int u_z, int v_z, int u_v) {
    const Constraint::ConstantOrientation c(i(), axes(joint_.frame_i), j(), axes(joint_.frame_j));
    link(c, {{u_v, -1.0}, {v_z, -1.0}, {u_z, 1.0}});
  }

  /// Adds one row: as Simbody's own constraint if f is a number and Simbody's equation is regular there, else
  /// as a custom constraint.
  void single(int row) {
    const Row& r = model_.rows[static_cast<std::size_t>(row)];
    if (!r.f.is_number || !(add_angle(row, r) || add_plane(row, r) || add_rod(row, r)))
      out_.push_back(custom_row(model_, index_, row, bodies_));
  }

  /// Not for nearly parallel vectors: acos(cosine), Simbody's parameter, amplifies rounding by 1 /
  /// sin(angle). The limit 0.9 of the cosine bounds this factor by 2.3.
  bool add_angle(int row, const Row& r) {
    const double sizes = vec(r.a_i).norm() * vec(r.a_j).norm(), cosine = r.f.value(model_.t)[0] / sizes;
    if (r.type != RowType::dp1 || std::abs(cosine) > 0.9) return false;
    const Constraint::ConstantAngle c(i(), UnitVec3(vec(r.a_i)), j(), UnitVec3(vec(r.a_j)),
                                      std::acos(cosine));
    link(c, {{row, 1 / sizes}});
    return true;
  }
  bool add_plane(int row, const Row& r) {
    if (r.type != RowType::dp2 && !(r.type == RowType::cd && r.i == ground)) return false;
    const double size = vec(r.a_i).norm();
    const double height = (SimTK::dot(vec(r.a_i), vec(r.s_i)) + r.f.value(model_.t)[0]) / size;
    const Constraint::PointInPlane c(i(), UnitVec3(vec(r.a_i)), height, j(), vec(r.s_j));
    link(c, {{row, 1 / size}});
    return true;
  }
  bool add_rod(int row, const Row& r) {
    const double square = r.f.value(model_.t)[0];
    if (r.type != RowType::d || square <= 0) return false;
    const double length = std::sqrt(square);
    const Constraint::Rod c(i(), vec(r.s_i), j(), vec(r.s_j), length);
    link(c, {{row, 1 / (2 * length)}});
    return true;
  }

  const Model& model_;
  int index_;
  const Joint& joint_;
  const BodyMap& bodies_;
  std::vector<LinkedConstraint>& out_;
};

}  // namespace

void add_built_in_rows(const Model& model, int joint, const BodyMap& bodies,
                       std::vector<LinkedConstraint>& out) {
  BuiltInRows(model, joint, bodies, out).add();
}

}  // namespace trivium::simbody
