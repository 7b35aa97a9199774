/// Compiles the conversion of scenes into mechanisms in long double.

#include "scenes/make_mechanism_impl.hpp"

namespace trivium {

template Mechanism<long double> make_mechanism<long double>(const scenes::Scene&);
template MechanismState<long double> make_state<long double>(const scenes::Scene&, long double t);
template Vector4<long double> euler_parameters_of<long double>(const scenes::Orientation&);

}  // namespace trivium
