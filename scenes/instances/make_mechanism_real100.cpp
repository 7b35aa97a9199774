/// Compiles the conversion of scenes into mechanisms in Real100.

#include "bodies/numbers/real50.hpp"
#include "scenes/make_mechanism_impl.hpp"

namespace trivium {

template Mechanism<Real100> make_mechanism<Real100>(const scenes::Scene&);
template MechanismState<Real100> make_state<Real100>(const scenes::Scene&, Real100 t);
template Vector4<Real100> euler_parameters_of<Real100>(const scenes::Orientation&);

}  // namespace trivium
