#include "validation/hard/methods.hpp"

#include <algorithm>

#include "integrators/methods.hpp"
#include "integrators/sundials/methods.hpp"

namespace trivium::hard {

namespace {

/// A method of each kind: explicit, implicit with index 3 and 2, of high order, symplectic.
const std::vector<std::string> one_of_each_kind{"dopri5", "generalized-alpha", "radau5", "rattle"};
const std::vector<std::string> high_order{"dopri5", "rkf78",  "bulirsch-stoer", "abm",
                                          "radau5", "radau9", "rattle4"};
const std::vector<std::string> implicit{
    "generalized-alpha", "generalized-alpha-gl2", "hht", "bdf", "radau5", "radau9", "cvode-bdf", "ida",
    "arkode-dirk"};

std::vector<std::string> names_without_sundials() {
  std::vector<std::string> names = integrators::method_names();
  for (const auto& entry : integrators::sundials_methods()) std::erase(names, entry.info.name);
  return names;
}

}  // namespace

const std::vector<MethodsOfFamily>& method_list() {
  static const std::vector<std::string> all = integrators::method_names();
  static const std::vector<std::string> without_sundials = names_without_sundials();
  static const std::vector<MethodsOfFamily> list{
      {"gimbal_lock", one_of_each_kind, all, "every method moves in the charts of the formulation"},
      {"gimbal_lock/sequences",
       {"dopri5"},
       {"dopri5"},
       "of each of the twelve sequences: methods do not know them"},
      {"spin", {"dopri5", "rkf78"}, high_order, "methods of order 2 would take 1e7 steps and more"},
      {"fast_top",
       {"dopri5", "rkf78"},
       {"rkf78", "bulirsch-stoer", "rattle4"},
       "a top of 1000 rad/s turns 16 000 times in 100 s: order 5 takes 1e7 steps, implicit methods minutes"},
      {"spin/many_flips",
       {"rkf78"},
       {"rkf78", "bulirsch-stoer", "radau9"},
       "of more than 20 flips others lose the phase: each flip enlarges errors"},
      {"inertia", one_of_each_kind, all, "singular and badly scaled mass matrices concern every method"},
      {"singular_positions", one_of_each_kind, all, "every method has to pass them"},
      {"singular_positions/large_four_bars",
       {"rkf78", "radau9"},
       {"rkf78", "radau9"},
       "of more than 10 loops for 20 s: methods of low order would take an hour"},
      {"tight_tolerances",
       {"ida", "radau5", "radau9"},
       {"ida", "hem4", "radau5", "radau9"},
       "the methods that end at singular positions; hedop5 does so in up to 1e6 steps"},
      {"long_runs",
       {"rattle", "generalized-alpha", "radau9"},
       {"rattle", "generalized-alpha", "radau9"},
       "a symplectic one in r-omega, a dissipative one in r-epsilon, an accurate one in r-p"},
      {"short_steps",
       {"generalized-alpha"},
       {"generalized-alpha", "generalized-alpha-gl2", "hht", "bdf", "radau5"},
       "constraints are solved by each of these; 2e6 steps of 5e-7 s"},
      {"stiff",
       {"radau5", "generalized-alpha"},
       implicit,
       "explicit methods follow a vibration of 1e5 rad/s with steps of 1e-5 s, whatever is asked"},
      {"drivers", one_of_each_kind, all, "every method meets the events"},
      {"size_and_place", one_of_each_kind, all,
       "tolerances, scales and iterations of every method have units"},
      {"size_and_place/large_mechanisms",
       {"dopri5", "radau5", "rattle"},
       {"dopri5", "radau5", "rattle"},
       "one step of a thousand bodies; their number of steps does not depend on the size"},
      {"faults", one_of_each_kind, all, "every method has to end its run with a message"},
      {"failing_allocation", one_of_each_kind, without_sundials,
       "SUNDIALS 6.4 itself uses the null of some failed allocations, and ends the program"},
      {"locked", one_of_each_kind, all, "every method has to hold a body still"},
  };
  return list;
}

const std::vector<WithoutSimbody>& cases_without_simbody() {
  static const std::vector<WithoutSimbody> list{
      {"near_lock", "states, not motions; simbody_reference compares states"},
      {"sequences", "its coordinates have no Euler sequence; its rows of the same flight are in flight"},
      {"raw_sequences", "as sequences"},
      {"printed_spin", "states, not motions"},
      {"redundancy", "states, not motions; simbody_reference compares states"},
      {"four_bars", "more than 10 loops take its integrators longer than 8 minutes"},
      {"tight_tolerances", "its rows of the same motions are in their own cases"},
      {"short_steps", "its integrators choose their steps: no law of given steps is theirs"},
      {"size_and_place",
       "none of more than 200 bodies: a ring of a thousand takes minutes; ladders are states"},
      {"faults", "the program trivium is what fails there"},
  };
  return list;
}

const std::vector<std::string>& methods_of(const std::string& name, bool quick) {
  const auto& list = method_list();
  const auto entry = std::find_if(list.begin(), list.end(), [&](const auto& e) { return e.of == name; });
  return quick ? entry->quick : entry->whole;
}

}  // namespace trivium::hard
