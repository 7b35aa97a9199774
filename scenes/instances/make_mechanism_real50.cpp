/// Compiles the conversion of scenes into mechanisms in Real50.

#include "bodies/numbers/real50.hpp"
#include "scenes/make_mechanism_impl.hpp"

namespace trivium {

template Mechanism<Real50> make_mechanism<Real50>(const scenes::Scene&);
template MechanismState<Real50> make_state<Real50>(const scenes::Scene&, Real50 t);
template Vector4<Real50> euler_parameters_of<Real50>(const scenes::Orientation&);

}  // namespace trivium
