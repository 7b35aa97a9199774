#pragma once
/// Adds rows to a Simbody model: as one custom constraint for each row, or as Simbody's own constraints where
/// they exist. Internal to the Simbody library; multiplier_signs.hpp documents signs and factors.

#include <Simbody.h>

#include <vector>

#include "validation/simbody/model.hpp"
#include "validation/simbody/multiplier_signs.hpp"

namespace trivium::simbody {

inline SimTK::Vec3 vec(const Vector3& v) { return {v[0], v[1], v[2]}; }
inline Vector3 array(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

/// Maps the bodies of a model to their mobilized bodies in Simbody.
struct BodyMap {
  SimTK::SimbodyMatterSubsystem& matter;
  std::vector<SimTK::MobilizedBodyIndex> index;

  SimTK::MobilizedBody& operator[](int body) const {
    return matter.updMobilizedBody(body == ground ? SimTK::MobilizedBodyIndex(0)
                                                  : index[static_cast<std::size_t>(body)]);
  }
};

/// Adds one row as a custom constraint.
LinkedConstraint custom_row(const Model& model, int joint, int row, const BodyMap& bodies);

/// Adds every row of a joint as a custom constraint.
void add_custom_rows(const Model& model, int joint, const BodyMap& bodies,
                     std::vector<LinkedConstraint>& out);

/// Adds the rows of a joint as Simbody's own constraints where these exist, else as custom constraints.
void add_built_in_rows(const Model& model, int joint, const BodyMap& bodies,
                       std::vector<LinkedConstraint>& out);

}  // namespace trivium::simbody
