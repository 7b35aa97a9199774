#include "validation/hard/family.hpp"

namespace trivium::hard {

std::vector<Family> families() {
  return {gimbal_lock(),        spin(),      inertia(), redundancy(),
          singular_positions(), long_runs(), stiff(),   drivers(),
          size_and_place(),     locked(),    faults()};
}

}  // namespace trivium::hard
