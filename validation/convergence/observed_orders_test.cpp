/// A run without an observable order must not pass: neither with rounding errors only, nor with NaN, nor with
/// a lambda that is not reported, nor with errors that do not decrease.

#include "validation/convergence/observed_orders.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace trivium::convergence {
namespace {

/// The result of a method of order 2 whose errors are exactly h^2 at h = 0.1, 0.05 and 0.025.
OrderResult second_order() {
  OrderResult row{"scene", "r-omega", "", {"method", "method", {}, 2, 2, 1}, {}, {}, {}};
  for (const double h : {0.1, 0.05, 0.025}) {
    row.h.push_back(h);
    row.errors.push_back({h * h, h * h, h * h, h * h});
  }
  row.floor.fill(1e-16);
  return row;
}

TEST(ObservedOrders, ThePublishedOnePasses) { EXPECT_TRUE(second_order().passed()); }

TEST(ObservedOrders, AnotherOneFails) {
  for (int quantity = 0; quantity < 4; ++quantity) {
    OrderResult row = second_order();
    for (std::size_t level = 0; level < row.h.size(); ++level) row.errors[level][quantity] = row.h[level];
    EXPECT_FALSE(row.passed()) << quantities[quantity];
  }
}

TEST(ObservedOrders, RoundingAloneShowsNone) {
  for (int quantity = 0; quantity < 4; ++quantity) {
    OrderResult row = second_order();
    for (Errors& errors : row.errors) errors[quantity] = 0;
    EXPECT_TRUE(row.is_rounding(quantity));
    EXPECT_FALSE(row.passed()) << quantities[quantity];
  }
}

TEST(ObservedOrders, AnErrorThatIsNoNumberFailsAtEveryLevel) {
  for (int quantity = 0; quantity < 4; ++quantity)
    for (std::size_t level = 0; level < 3; ++level)
      for (const double none :
           {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        OrderResult row = second_order();
        row.errors[level][quantity] = none;
        EXPECT_FALSE(row.passed()) << quantities[quantity] << " at " << row.h[level];
      }
}

}  // namespace
}  // namespace trivium::convergence
