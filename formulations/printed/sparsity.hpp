#pragma once
/// How full the augmented matrix of each formulation is, all rows of Phi in it. Counted from the blocks;
/// nothing dense is built, so the number of bodies does not matter.

#include <string>
#include <vector>

#include "mechanism/model.hpp"

namespace trivium {

/// Size and entries that are not zero of one formulation's augmented matrix.
struct Sparsity {
  std::string name;
  long size = 0, nonzeros = 0;
  double percent() const {
    return size == 0 ? 0.0
                     : 100.0 * static_cast<double>(nonzeros) /
                           (static_cast<double>(size) * static_cast<double>(size));
  }
};

/// Of every formulation of the list.
std::vector<Sparsity> augmented_sparsity(const Model<double>& model);

}  // namespace trivium
