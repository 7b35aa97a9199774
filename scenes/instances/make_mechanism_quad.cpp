/// Compiles the conversion of scenes into mechanisms in Quad.

#include "bodies/numbers/quad.hpp"
#include "scenes/make_mechanism_impl.hpp"

namespace trivium {

template Mechanism<Quad> make_mechanism<Quad>(const scenes::Scene&);
template MechanismState<Quad> make_state<Quad>(const scenes::Scene&, Quad t);
template Vector4<Quad> euler_parameters_of<Quad>(const scenes::Orientation&);

}  // namespace trivium
