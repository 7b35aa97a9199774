/// Compiles the conversion of scenes into mechanisms in double.

#include "scenes/make_mechanism_impl.hpp"

namespace trivium {

template Mechanism<double> make_mechanism<double>(const scenes::Scene&);
template MechanismState<double> make_state<double>(const scenes::Scene&, double t);
template Vector4<double> euler_parameters_of<double>(const scenes::Orientation&);

}  // namespace trivium
