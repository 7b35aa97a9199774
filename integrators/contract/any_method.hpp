#pragma once
/// Type erasure of methods: AnyMethod is the interface behind which every method works on AnySystem. The
/// entries in the list of methods (MethodEntry) make them. A step costs one virtual call, which is small
/// compared with the step.

#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "integrators/contract/any_system.hpp"
#include "integrators/contract/memory.hpp"
#include "integrators/contract/method.hpp"

namespace trivium::integrators {

/// Any Method on AnySystem. `step`, `restart`, `shorten` and `counters` are those of a Method. If
/// interpolates() is true, output times do not limit the steps of the method. A step may then contain output
/// times, at which `interpolate` gives the state with the accuracy of the method.
template <class S>
class AnyMethod {
 public:
  virtual ~AnyMethod() = default;
  virtual void step(AnySystem<S>& system, S& t, StateVector<S>& y, const S& stop) = 0;
  virtual void restart() = 0;
  virtual bool shorten() = 0;
  virtual const Counters& counters() const = 0;
  /// The raw lambda: the multipliers that the method computes together with its step. Null if the method has
  /// none. May be null before the first step after the start or a restart.
  virtual const StateVector<S>* lambda() const = 0;
  /// Whether the method can compute the state within its last step.
  virtual bool interpolates() const { return false; }
  /// Sets y, and the method's lambda(), to their values at a time t within the last step.
  virtual void interpolate(const S& /*t*/, StateVector<S>& /*y*/) {}
  /// The relative violation of positions at the end of a chosen step, before its projection, above which the
  /// method's estimate of its error is not believed, so that the step is taken back.
  virtual S largest_drift() const { return std::numeric_limits<S>::max(); }
  /// The numbers that the method keeps from step to step (memory.hpp); empty if it keeps none, if it does
  /// not show them (bdf, Odeint's and SUNDIALS' multistep methods, and all methods under ErrorControl or
  /// ReversibleSteps), or if it has not begun.
  virtual std::vector<double> memory() { return {}; }
  /// Begins at (t, y) with the memory of another object of the same method; `stop` is the end of the next
  /// given step. Throws a std::invalid_argument if the parts do not fit. A method without memory does
  /// nothing.
  virtual void recall(AnySystem<S>& /*system*/, const S& /*t*/, const StateVector<S>& /*y*/,
                      const S& /*stop*/, const std::vector<double>& /*memory*/) {}
};

/// AnyMethod for a given Method. The optional functions that M does not have return their default.
template <class S, Method<AnySystem<S>> M>
class MethodAdapter final : public AnyMethod<S> {
 public:
  explicit MethodAdapter(M method) : method_(std::move(method)) {}
  void step(AnySystem<S>& system, S& t, StateVector<S>& y, const S& stop) override {
    method_.step(system, t, y, stop);
  }
  void restart() override { method_.restart(); }
  bool shorten() override { return method_.shorten(); }
  const Counters& counters() const override { return method_.counters(); }
  const StateVector<S>* lambda() const override {
    if constexpr (requires { method_.lambda(); })
      return method_.lambda();
    else
      return nullptr;
  }
  bool interpolates() const override {
    if constexpr (requires { method_.interpolates(); })
      return method_.interpolates();
    else
      return false;
  }
  void interpolate(const S& t, StateVector<S>& y) override {
    if constexpr (requires { method_.interpolate(t, y); }) method_.interpolate(t, y);
  }
  S largest_drift() const override {
    if constexpr (requires { method_.largest_drift(); })
      return method_.largest_drift();
    else
      return AnyMethod<S>::largest_drift();
  }
  std::vector<double> memory() override {
    std::vector<double> numbers;
    if constexpr (has_memory)
      if (method_.has_begun()) method_.show_memory(MemorySaver<S>(numbers));
    return numbers;
  }
  void recall(AnySystem<S>& system, const S& t, const StateVector<S>& y, const S& stop,
              const std::vector<double>& memory) override {
    if constexpr (has_memory) {
      MemoryReader<S> reader(memory);
      method_.begin(system, t, y, stop);
      method_.show_memory(reader);
      reader.end();
    }
  }

 private:
  static constexpr bool has_memory = requires(M & method, MemoryReader<S>& show) {
    method.show_memory(show);
  };

  M method_;
};

/// Puts a method behind the interface AnyMethod.
template <class S, Method<AnySystem<S>> M>
std::unique_ptr<AnyMethod<S>> adapt(M method) {
  return std::make_unique<MethodAdapter<S, M>>(std::move(method));
}

}  // namespace trivium::integrators
