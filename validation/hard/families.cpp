#include "validation/hard/family.hpp"

namespace trivium::hard {

std::vector<Family> families() { return {gimbal_lock(), spin(), inertia(), redundancy()}; }

}  // namespace trivium::hard
