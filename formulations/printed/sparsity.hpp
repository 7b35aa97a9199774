#pragma once
/// The sparsity of the augmented matrix of each formulation, with all rows of Phi. The entries are counted
/// from the blocks without a dense matrix, so the number of bodies is not limited.

#include <string>
#include <vector>

#include "mechanism/model.hpp"

namespace trivium {

/// Size and number of nonzero entries of the augmented matrix of one formulation.
struct Sparsity {
  std::string name;
  long size = 0, nonzeros = 0;
  double percent() const {
    return size == 0 ? 0.0
                     : 100.0 * static_cast<double>(nonzeros) /
                           (static_cast<double>(size) * static_cast<double>(size));
  }
};

/// The sparsity in every formulation of the library.
std::vector<Sparsity> augmented_sparsity(const Model<double>& model);

}  // namespace trivium
