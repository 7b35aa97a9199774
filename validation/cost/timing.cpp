/// Lets Google Benchmark repeat the pieces of work in random order, without its own output, and takes
/// medians.

#include "validation/cost/timing.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <string>

#include "simulation/cpu_time.hpp"

namespace trivium::cost {

namespace {

/// Collects the times of all repetitions for each piece of work; prints nothing.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::size_t size) : nanoseconds_(size) {}

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration && !run.error_occurred)
        nanoseconds_[std::stoul(run.run_name.function_name)].push_back(run.GetAdjustedCPUTime());
  }

  double median_microseconds(std::size_t k) {
    std::vector<double>& t = nanoseconds_[k];
    const auto middle = t.begin() + static_cast<std::ptrdiff_t>(t.size() / 2);
    std::nth_element(t.begin(), middle, t.end());
    return *middle / 1e3;
  }

 private:
  std::vector<std::vector<double>> nanoseconds_;
};

void initialise_once() {
  static const bool done = [] {
    std::string name = "acceleration_cost", interleaved = "--benchmark_enable_random_interleaving=true";
    std::array<char*, 3> arguments{name.data(), interleaved.data(), nullptr};
    int count = 2;
    benchmark::Initialize(&count, arguments.data());
    return true;
  }();
  static_cast<void>(done);
}

}  // namespace

std::vector<double> median_microseconds(const std::vector<std::function<void()>>& work,
                                        const Timing& timing) {
  initialise_once();
  for (std::size_t k = 0; k < work.size(); ++k)
    benchmark::RegisterBenchmark(std::to_string(k).c_str(),
                                 [&one = work[k]](benchmark::State& state) {
                                   for (auto _ : state) one();
                                 })
        ->MinTime(timing.seconds)
        ->Repetitions(timing.repetitions)
        ->Unit(benchmark::kNanosecond);
  Collector collector(work.size());
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  std::vector<double> medians;
  for (std::size_t k = 0; k < work.size(); ++k) medians.push_back(collector.median_microseconds(k));
  return medians;
}

double seconds_of(const std::function<void()>& work) {
  const double start = cpu_seconds();
  work();
  return cpu_seconds() - start;
}

}  // namespace trivium::cost
