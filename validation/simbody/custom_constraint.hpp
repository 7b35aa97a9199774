#pragma once
/// A basic constraint as a Simbody Constraint::Custom whose constraint error is Phi itself. Internal to the
/// Simbody library.

#include "validation/simbody/rows.hpp"

namespace trivium::simbody {

/// The row Phi = x . y - f for two vectors x and y that depend on the motion of the bodies. Computes Phi, its
/// first two time derivatives and the forces G^T lambda from Simbody's body motions.
class CustomRow : public SimTK::Constraint::Custom::Implementation {
 public:
  CustomRow(const Row& row, const BodyMap& bodies);

  Implementation* clone() const override { return new CustomRow(*this); }

  void calcPositionErrors(const SimTK::State& state,
                          const SimTK::Array_<SimTK::Transform, SimTK::ConstrainedBodyIndex>& X,
                          const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&,
                          SimTK::Array_<SimTK::Real>& error) const override;
  void calcPositionDotErrors(const SimTK::State& state,
                             const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& V,
                             const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&,
                             SimTK::Array_<SimTK::Real>& error) const override;
  void calcPositionDotDotErrors(const SimTK::State& state,
                                const SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& A,
                                const SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&,
                                SimTK::Array_<SimTK::Real>& error) const override;
  void addInPositionConstraintForces(
      const SimTK::State& state, const SimTK::Array_<SimTK::Real>& multipliers,
      SimTK::Array_<SimTK::SpatialVec, SimTK::ConstrainedBodyIndex>& body_forces,
      SimTK::Array_<SimTK::Real, SimTK::ConstrainedQIndex>&) const override;

 private:
  /// A body's motion in Ground; V and A are zero where they are not needed.
  struct BodyMotion {
    SimTK::Transform X;
    SimTK::SpatialVec V{SimTK::Vec3(0), SimTK::Vec3(0)}, A{SimTK::Vec3(0), SimTK::Vec3(0)};
  };
  /// A vector and its first two time derivatives.
  struct Moving {
    SimTK::Vec3 value{0}, rate{0}, acceleration{0};
  };
  struct Factors {
    Moving x, y;
    Vector3 f;  ///< f, f', f''
  };

  static Moving follow(const BodyMotion& body, const Moving& in_body);
  Moving offset(const BodyMotion& i, const BodyMotion& j) const;
  Factors factors(const BodyMotion& i, const BodyMotion& j, double t) const;
  BodyMotion from_state(const SimTK::State& state, SimTK::ConstrainedBodyIndex body) const;

  Row row_;
  SimTK::ConstrainedBodyIndex i_, j_;
};

}  // namespace trivium::simbody
