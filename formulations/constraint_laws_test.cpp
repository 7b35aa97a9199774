/// Phi_q, nu, gamma and row_acceleration of every basic constraint are the derivatives of Phi along any
/// path, in the coordinates of every formulation.

#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "constraints/constraint_row.hpp"
#include "formulations/testing/moving_body.hpp"

namespace trivium {
namespace {

using test::Random, test::RowErrors, test::roundings, test::Taylor;

template <class F>
class ConstraintLaws : public testing::Test {};
TYPED_TEST_SUITE(ConstraintLaws, test::TestedFormulations, test::FormulationNames);

/// Bounds the largest violation of the laws for each kind of constraint, over all charts.
template <class F, class Measure>
void for_all_kinds(const Measure& measure, double bound) {
  for (int kind = 0; kind < test::basic_kinds; ++kind) {
    RowErrors worst;
    Random random(41 + kind);
    test::for_all_charts([&](const ChartOptions& options) {
      const auto i = test::random_path<F>(random, options), j = test::random_path<F>(random, options);
      measure(kind, random, i, j, worst);
    });
    EXPECT_LE(worst.value, bound) << test::basic_kind_name(kind);
    EXPECT_LE(worst.velocity, bound) << test::basic_kind_name(kind);
    EXPECT_LE(worst.acceleration, bound) << test::basic_kind_name(kind);
    EXPECT_LE(worst.row_acceleration, bound) << test::basic_kind_name(kind);
  }
}

TYPED_TEST(ConstraintLaws, JacobianIsTheDerivativeOfPhiInEveryCoordinate) {
  using F = TypeParam;
  using S = typename F::Scalar;
  constexpr int n = F::rotational_unknowns;
  for_all_kinds<F>(
      [](int kind, Random& random, test::Path<F> i, test::Path<F> j, RowErrors& worst) {
        const std::uint64_t seed = random.index(1000);
        const Taylor<S> frozen{S(random.uniform())};
        i.r_dot.setZero();
        i.q_dot.setZero();
        j.r_dot.setZero();
        j.q_dot.setZero();
        for (test::Path<F>* body : {&i, &j})
          for (int k = 0; k < 3 + n; ++k) {
            if (k < 3)
              body->r_dot = Vector3<S>::Unit(k);
            else
              body->q_dot = F::Unknown::Unit(k - 3);
            measure_row(kind, seed, test::moving_body(i), test::moving_body(j), frozen, worst);
            body->r_dot.setZero();
            body->q_dot.setZero();
          }
      },
      roundings<S>(500));
}

TYPED_TEST(ConstraintLaws, NuAndGammaCompleteTheDerivativesOfPhi) {
  using F = TypeParam;
  using S = typename F::Scalar;
  for_all_kinds<F>(
      [](int kind, Random& random, const test::Path<F>& i, const test::Path<F>& j, RowErrors& worst) {
        measure_row(kind, random.index(1000), test::moving_body(i), test::moving_body(j),
                    Taylor<S>::parameter(S(random.uniform())), worst);
      },
      roundings<S>(10000));
}

}  // namespace
}  // namespace trivium
