#include "integrators/time_grid.hpp"

#include <gtest/gtest.h>

namespace trivium::integrators {
namespace {

std::vector<Stop<double>> stops(const TimeGrid& grid) {
  std::vector<Stop<double>> all;
  TimeGrid::Walk<double> walk(grid);
  while (const auto stop = walk.next()) all.push_back(*stop);
  return all;
}

TEST(TimeGrid, TimesAreMultiplesAndNeverSums) {
  const auto all = stops(TimeGrid(0, 1, {}, 0.1));
  ASSERT_EQ(all.size(), 10u);
  for (std::size_t k = 0; k < all.size(); ++k)
    EXPECT_EQ(all[k].t, k + 1 == all.size() ? 1.0 : 0.1 * static_cast<double>(k + 1));
}

TEST(TimeGrid, OutputsStandAtTheirOwnMultiplesAndAtTheEnd) {
  const auto all = stops(TimeGrid(2, 3, 0.3));
  ASSERT_EQ(all.size(), 4u);
  for (const auto& stop : all) EXPECT_TRUE(stop.is_output);
  EXPECT_EQ(all[2].t, 2 + 3 * 0.3);
  EXPECT_EQ(all[3].t, 3);
}

TEST(TimeGrid, OfStepsThoseAtOutputsAreOutputs) {
  const auto all = stops(TimeGrid(0, 1, 0.5, 0.125));
  ASSERT_EQ(all.size(), 8u);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(all[k].is_output, (k + 1) % 4 == 0) << k;
}

TEST(TimeGrid, EventsWithinTheRunAreStopsOnce) {
  const auto all = stops(TimeGrid(0, 1, 0.5, {}, {0.7, -1, 0.5, 0.3, 0.3, 1, 2}));
  ASSERT_EQ(all.size(), 4u);
  EXPECT_TRUE(all[0].t == 0.3 && all[0].is_event && !all[0].is_output);
  EXPECT_TRUE(all[1].t == 0.5 && all[1].is_event && all[1].is_output);
  EXPECT_TRUE(all[2].t == 0.7 && all[2].is_event);
  EXPECT_TRUE(all[3].t == 1 && all[3].is_event && all[3].is_output);
}

TEST(TimeGrid, AStepThatDoesNotDivideTheRunIsAnErrorThatNamesOneThatDoes) {
  try {
    TimeGrid(0, 1, {}, 0.3);
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("0.333"), std::string::npos) << error.what();
  }
  EXPECT_THROW(TimeGrid(0, 1, 0.25, 0.1), UsageError);
  EXPECT_THROW(TimeGrid(0, 0), UsageError);
  EXPECT_THROW(TimeGrid(0, 1, {}, -0.1), UsageError);
  EXPECT_NO_THROW(TimeGrid(0, 10, 0.1, 0.001));
}

}  // namespace
}  // namespace trivium::integrators
