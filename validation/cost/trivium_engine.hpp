#pragma once
/// Trivium's structured solver of one formulation, with the interface of an engine. The template is included
/// directly if a Scalar is needed that trivium_engines.hpp does not offer.

#include <string>
#include <vector>

#include "formulations/structured/acceleration_solver.hpp"
#include "scenes/make_mechanism.hpp"
#include "validation/cost/trivium_engines.hpp"

namespace trivium::cost {

template <class S>
Vector3 plain(const trivium::Vector3<S>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

template <class S>
std::vector<double> plain(const VectorX<S>& v) {
  std::vector<double> out;
  for (const S& x : v) out.push_back(static_cast<double>(x));
  return out;
}

inline Refinement refinement_of(Refined refined) {
  return refined == Refined::yes ? Refinement::as_needed : Refinement::none;
}

template <class F>
class TriviumEngine : public Engine {
 public:
  using S = typename F::Scalar;

  TriviumEngine(const scenes::Scene& scene, Refined refined)
      : mechanism_(make_mechanism<S>(scene)),
        state_(to_coordinates<F>(mechanism_, make_state<S>(scene), ChartOptions{})),
        solver_(mechanism_),
        refinement_(refinement_of(refined)) {}

  void evaluate() override { solver_.solve(state_, S(0), refinement_); }

  std::vector<Vector3> r_ddot() override {
    std::vector<Vector3> r_ddot;
    for (int b = 0; b < mechanism_.nb(); ++b) r_ddot.push_back(plain<S>(solver_.r_ddot(b)));
    return r_ddot;
  }
  std::vector<double> lambda() override { return plain<S>(solver_.lambda()); }
  std::vector<bool> unique() { return solver_.unique(); }

 private:
  Mechanism<S> mechanism_;
  std::vector<BodyState<F>> state_;
  AccelerationSolver<F> solver_;
  Refinement refinement_;
};

}  // namespace trivium::cost
