/// Sums the squares of lambda and of accelerations with the weights of the row analysis, in double.

#include "formulations/analysis/comparison.hpp"

#include <cmath>

#include "bodies/numbers/real50.hpp"

namespace trivium {

template <class Scalar>
Comparison compare_lambda(const RowAnalysis& rows, const VectorX<Scalar>& lambda_1,
                          const VectorX<Scalar>& lambda_2) {
  double difference = 0, size_1 = 0, size_2 = 0, bound = 0, uncancelled = 0;
  for (Eigen::Index k = 0; k < lambda_1.size(); ++k) {
    const double E = rows.E[k];
    if (E == 0) continue;
    const auto square = [](double x) { return x * x; };
    bound += square(rows.schur_rhs_bound[k] / E);
    if (rows.schur_rhs_bound_uncancelled.size() > 0)
      uncancelled += square(rows.schur_rhs_bound_uncancelled[k] / E);
    if (!rows.unique[k]) continue;
    difference += square(E * static_cast<double>(Scalar(lambda_1[k] - lambda_2[k])));
    size_1 += square(E * static_cast<double>(lambda_1[k]));
    size_2 += square(E * static_cast<double>(lambda_2[k]));
  }
  return {std::sqrt(difference), std::sqrt(size_1), std::sqrt(size_2), std::sqrt(bound),
          std::sqrt(uncancelled)};
}

template <class Scalar>
double lambda_distance(const RowAnalysis& rows, const VectorX<Scalar>& lambda_1,
                       const VectorX<Scalar>& lambda_2) {
  return compare_lambda(rows, lambda_1, lambda_2).relative();
}

template <class Scalar>
AccelerationComparison compare_accelerations(const RowAnalysis& rows, const PhysicalSolution<Scalar>& a,
                                             const PhysicalSolution<Scalar>& b) {
  double r = 0, omega = 0, size_a = 0, size_b = 0;
  for (std::size_t n = 0; n < a.r_ddot.size(); ++n) {
    const auto weigh = [&](const Vector3<Scalar>& v, std::size_t offset) {
      return rows.acceleration_scale.segment<3>(static_cast<Eigen::Index>(6 * n + offset))
          .cwiseProduct(scalar_cast<double>(v))
          .squaredNorm();
    };
    r += weigh(a.r_ddot[n] - b.r_ddot[n], 0);
    omega += weigh(a.omega_bar_dot[n] - b.omega_bar_dot[n], 3);
    size_a += weigh(a.r_ddot[n], 0) + weigh(a.omega_bar_dot[n], 3);
    size_b += weigh(b.r_ddot[n], 0) + weigh(b.omega_bar_dot[n], 3);
  }
  const auto against_all = [&](double square) {
    return Comparison{std::sqrt(square), std::sqrt(size_a), std::sqrt(size_b), rows.acceleration_bound, 0};
  };
  return {against_all(r + omega), against_all(r), against_all(omega)};
}

template <class Scalar>
AccelerationDistance acceleration_distance(const RowAnalysis& rows, const PhysicalSolution<Scalar>& a,
                                           const PhysicalSolution<Scalar>& b) {
  const AccelerationComparison c = compare_accelerations(rows, a, b);
  return {c.all.relative(), c.r_ddot.relative(), c.omega_bar_dot.relative()};
}

#define TRIVIUM_COMPARISONS(Scalar)                                                                          \
  template Comparison compare_lambda(const RowAnalysis&, const VectorX<Scalar>&, const VectorX<Scalar>&);    \
  template double lambda_distance(const RowAnalysis&, const VectorX<Scalar>&, const VectorX<Scalar>&);       \
  template AccelerationComparison compare_accelerations(const RowAnalysis&, const PhysicalSolution<Scalar>&, \
                                                        const PhysicalSolution<Scalar>&);                    \
  template AccelerationDistance acceleration_distance(const RowAnalysis&, const PhysicalSolution<Scalar>&,   \
                                                      const PhysicalSolution<Scalar>&)
TRIVIUM_COMPARISONS(float);
TRIVIUM_COMPARISONS(double);
TRIVIUM_COMPARISONS(long double);
TRIVIUM_COMPARISONS(Quad);
TRIVIUM_COMPARISONS(Real50);
TRIVIUM_COMPARISONS(Real100);
#undef TRIVIUM_COMPARISONS

}  // namespace trivium
