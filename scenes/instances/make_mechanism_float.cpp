/// Compiles the conversion of scenes into mechanisms in float.

#include "scenes/make_mechanism_impl.hpp"

namespace trivium {

template Mechanism<float> make_mechanism<float>(const scenes::Scene&);
template MechanismState<float> make_state<float>(const scenes::Scene&, float t);
template Vector4<float> euler_parameters_of<float>(const scenes::Orientation&);

}  // namespace trivium
