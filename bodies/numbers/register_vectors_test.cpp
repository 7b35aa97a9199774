/// Operations on padded vectors give the same results as those on plain vectors, and keep the padding zero.

#include "bodies/numbers/register_vectors.hpp"

#include "bodies/numbers/quad.hpp"
#include "bodies/testing/properties.hpp"

namespace trivium {
namespace {

using test::distance, test::draw_vector, test::for_all, test::roundings;

template <class S>
class PaddedVectors : public testing::Test {};
using Scalars = testing::Types<float, double, long double, Quad>;
TYPED_TEST_SUITE(PaddedVectors, Scalars);

template <class S>
Matrix3<S> draw_matrix() {
  Matrix3<S> M;
  for (int k = 0; k < 3; ++k) M.col(k) = draw_vector<S, 3>(9);
  return M;
}
/// Whether the fourth entry of every column, if there is one, is 0.
template <class S, int n>
bool is_padded(const PaddedColumns<S, n>& M) {
  return (M.bottomRows(padded_size<S> - 3).array() == S(0)).all();
}

TYPED_TEST(PaddedVectors, LoseNothingOnTheWayThereAndBack) {
  using S = TypeParam;
  for_all([] {
    const Vector3<S> v = draw_vector<S, 3>(9);
    const Matrix3<S> M = draw_matrix<S>();
    RC_ASSERT(unpadded<S>(padded<S>(v)) == v);
    RC_ASSERT((is_padded<S, 1>(padded<S>(v))));
    RC_ASSERT(padded_columns<S>(M).template topRows<3>() == M);
    RC_ASSERT((is_padded<S, 3>(padded_columns<S>(M))));
  });
}

TYPED_TEST(PaddedVectors, MultiplyAsPlainOnes) {
  using S = TypeParam;
  for_all([] {
    const Matrix3<S> M = draw_matrix<S>();
    const Vector3<S> v = draw_vector<S, 3>(9), w = draw_vector<S, 3>(9);
    const PaddedColumns<S, 3> columns = padded_columns<S>(M);
    const Padded<S> product = times<S, 3>(columns, v),
                    along = padded_transpose_times<S>(columns, padded<S>(v)),
                    cross = cross_product<S>(padded<S>(v), padded<S>(w));
    const double bound = roundings<S>(1000);
    RC_ASSERT(distance(unpadded<S>(product), M * v) <= bound);
    RC_ASSERT(distance(unpadded<S>(along), M.transpose() * v) <= bound);
    RC_ASSERT(distance(transpose_times<S, 3>(columns, padded<S>(v)), M.transpose() * v) <= bound);
    RC_ASSERT(distance(transpose_times<S, 2>(columns.template leftCols<2>(), padded<S>(v)),
                       M.template leftCols<2>().transpose() * v) <= bound);
    RC_ASSERT(distance(unpadded<S>(cross), v.cross(w)) <= bound);
    for (const Padded<S>& result : {product, along, cross}) RC_ASSERT((is_padded<S, 1>(result)));
  });
}

TYPED_TEST(PaddedVectors, TransposeExactly) {
  using S = TypeParam;
  for_all([] {
    const Matrix3<S> M = draw_matrix<S>();
    const PaddedColumns<S, 3> T = transposed<S>(padded_columns<S>(M));
    RC_ASSERT(T.template topRows<3>() == M.transpose());
    RC_ASSERT((is_padded<S, 3>(T)));
    PaddedColumns<S, 3> sum = padded_columns<S>(M);
    add_with_transpose<S>(padded_columns<S>(M), sum);
    RC_ASSERT(sum.template topRows<3>() == M + (M + M.transpose()));
  });
}

}  // namespace
}  // namespace trivium
