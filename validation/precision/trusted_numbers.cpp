/// Distances of motions from the tables of trusted numbers (declared in runs.hpp).

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "base/raise.hpp"
#include "scenes/catalogue.hpp"
#include "validation/harness/trusted_numbers.hpp"
#include "validation/precision/runs.hpp"

namespace trivium::precision {

namespace {

/// The difference between a sample and a row of the table.
using Apart = std::function<double(const MotionSample&, const TrustedNumbers&, std::size_t row)>;

/// The distance in the x-y plane of a body's centre of mass from the point in the table, shifted by (x, y).
Apart place_of(std::size_t body, double x, double y) {
  return [=](const MotionSample& sample, const TrustedNumbers& file, std::size_t row) {
    const auto& r = sample.state.pose[body].r;
    return std::hypot(r[0] - x - file["x"][row], r[1] - y - file["y"][row]);
  };
}

double andrews(const MotionSample& sample, const TrustedNumbers& file, std::size_t) {
  const auto angles = andrews_angles(file);
  double most = 0;
  for (std::size_t b = 0; b < angles.size(); ++b)
    raise(most, apart_from_angle(sample.state.pose[b].p, angles[b]));
  return most;
}

}  // namespace

std::optional<double> apart_from_trusted(const std::string& scene, const std::vector<MotionSample>& samples) {
  struct Trusted {
    Apart apart;
    std::optional<double> only_time;
  };
  // in x, the centre of the last coupler is N - 1/2 from the first joint of the couplers
  static const std::map<std::string, Trusted> trusted{{"a01_pendulum", {place_of(0, 0, 0), {}}},
                                                      {"n_four_bar_1", {place_of(2, 0.5, 0), {}}},
                                                      {"n_four_bar_2", {place_of(4, 1.5, 0), {}}},
                                                      {"n_four_bar_40", {place_of(80, 39.5, 0), {}}},
                                                      {"andrews_squeezer", {andrews, 0.03}}};
  const auto found = trusted.find(scene);
  if (found == trusted.end()) return {};
  const TrustedNumbers file(reference_directory(), scene);
  const auto& [apart, only_time] = found->second;
  const std::vector<double> times = only_time ? std::vector{*only_time} : file["t"];
  std::optional<double> most;
  for (const MotionSample& sample : samples)
    for (std::size_t row = 0; row < times.size(); ++row)
      if (std::abs(sample.state.t - times[row]) <= 1e-12 * (1 + times[row]) && sample.state.t > 0)
        raise(most ? *most : most.emplace(0), apart(sample, file, row));
  return most;
}

}  // namespace trivium::precision
