#pragma once
/// Rows as Simbody constraints: one custom constraint a row, or Simbody's own where it has one. Internal to
/// the Simbody library; multiplier_signs.hpp documents sign and scale.

#include <Simbody.h>

#include <vector>

#include "validation/simbody/model.hpp"
#include "validation/simbody/multiplier_signs.hpp"

namespace trivium::simbody {

inline SimTK::Vec3 vec(const Vector3& v) { return {v[0], v[1], v[2]}; }
inline Vector3 array(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

/// The mobilized bodies of the model's bodies.
struct BodyMap {
  SimTK::SimbodyMatterSubsystem& matter;
  std::vector<SimTK::MobilizedBodyIndex> index;

  SimTK::MobilizedBody& operator[](int body) const {
    return matter.updMobilizedBody(body == ground ? SimTK::MobilizedBodyIndex(0)
                                                  : index[static_cast<std::size_t>(body)]);
  }
};

/// One row as a custom constraint.
LinkedConstraint custom_row(const Model& model, int joint, int row, const BodyMap& bodies);

/// Every row of a joint as a custom constraint.
void add_custom_rows(const Model& model, int joint, const BodyMap& bodies,
                     std::vector<LinkedConstraint>& out);

/// The same rows through Simbody's own constraints, as far as there are any.
void add_built_in_rows(const Model& model, int joint, const BodyMap& bodies,
                       std::vector<LinkedConstraint>& out);

}  // namespace trivium::simbody
