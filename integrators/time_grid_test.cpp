/// The times of a run: steps, outputs and events, and which of them coincide.

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
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_EQ(all[k].t, 0.1 * static_cast<double>(k + 1));
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

/// From any stop on, the remaining stops are those of the whole run.
TEST(TimeGrid, OnTheWayTheSameTimesAreToCome) {
  for (const TimeGrid& grid : {TimeGrid(0.1, 1.1, 0.2, 0.01), TimeGrid(-3, 1, 0.3),
                               TimeGrid(0, 1, 0.25, 0.05, {0.3, 0.52, 0.25}), TimeGrid(1, 2, {}, 1e-3)}) {
    const auto all = stops(grid);
    for (std::size_t k = 0; k + 1 < all.size(); ++k) {
      const auto rest = stops(grid.from(all[k].t));
      ASSERT_EQ(rest.size(), all.size() - k - 1) << k;
      for (std::size_t n = 0; n < rest.size(); ++n) {
        EXPECT_EQ(rest[n].t, all[k + 1 + n].t);
        EXPECT_EQ(rest[n].is_output, all[k + 1 + n].is_output);
        EXPECT_EQ(rest[n].is_event, all[k + 1 + n].is_event);
      }
      // also from a time between two stops
      EXPECT_EQ(stops(grid.from((all[k].t + all[k + 1].t) / 2)).size(), rest.size());
    }
    EXPECT_THROW(grid.from(grid.end()), UsageError);
    EXPECT_THROW(grid.from(grid.start() - 1), UsageError);
  }
}

/// A run to 0.3 and a run that continues beyond take the same steps: 3 x 0.1 is not 0.3 in double.
TEST(TimeGrid, ALongestStepIsAnEarlierEndOfChosenSteps) {
  const TimeGrid grid = TimeGrid(0, 1).limited_to(0.25);
  EXPECT_EQ(grid.latest_end(0.5, 1.0), 0.75);
  EXPECT_EQ(grid.latest_end(0.75, 0.9), 0.9);
  EXPECT_EQ(TimeGrid(0, 1).latest_end(0.5, 1.0), 1.0);
  EXPECT_THROW(TimeGrid(0, 1).limited_to(0), UsageError);
  EXPECT_THROW(TimeGrid(0, 1, {}, 0.5).limited_to(0.25), UsageError);
}

TEST(TimeGrid, GivenStepsDoNotDependOnTheEnd) {
  EXPECT_EQ(stops(TimeGrid(0, 0.3, {}, 0.1)).back().t, stops(TimeGrid(0, 1, {}, 0.1))[2].t);
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
