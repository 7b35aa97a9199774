/// Lists RATTLE of order 2 and its composition of order 4 with their properties.

#include "integrators/symplectic/methods.hpp"

#include <utility>

#include "integrators/quad.hpp"
#include "integrators/symplectic/rattle.hpp"
#include "integrators/symplectic/reversible_steps.hpp"

namespace trivium::integrators {

template <class S>
std::vector<MethodEntry<S>> symplectic_methods() {
  return {
      {{.name = "rattle",
        .summary = "RATTLE on Lie groups, symplectic if M is constant",
        .order = 2,
        .takes_given_steps = true,
        .chooses_steps = true,
        .meets_constraints = true,
        .needs_constant_inertia = true},
       [](const MethodRequest& request) {
         Rattle<AnySystem<S>> rattle(2);
         if (!request.tolerances) return adapt<S>(std::move(rattle));
         return adapt<S>(ReversibleSteps<AnySystem<S>>(std::move(rattle), *request.tolerances));
       }},
      {{.name = "rattle4",
        .summary = "RATTLE composed to order 4, symplectic if M is constant",
        .order = 4,
        .takes_given_steps = true,
        .meets_constraints = true,
        .needs_constant_inertia = true,
        .raw_lambda_order = 2},
       [](const MethodRequest&) { return adapt<S>(Rattle<AnySystem<S>>(4)); }},
  };
}

template std::vector<MethodEntry<double>> symplectic_methods<double>();
template std::vector<MethodEntry<Quad>> symplectic_methods<Quad>();

}  // namespace trivium::integrators
