#pragma once
/// Any method behind virtual calls, one for each step, on any system: what a method's name leads to. Within a
/// step a method knows its own type, so that virtual calls cost nothing that shows.

#include <memory>
#include <utility>
#include <vector>

#include "integrators/contract/any_system.hpp"
#include "integrators/contract/memory.hpp"
#include "integrators/contract/method.hpp"

namespace trivium::integrators {

/// Any Method on AnySystem. One that `interpolates` steps over outputs, and `interpolate` sets y to the state
/// at a time of its last step, by a formula of the method's own order.
template <class S>
class AnyMethod {
 public:
  virtual ~AnyMethod() = default;
  virtual void step(AnySystem<S>& system, S& t, StateVector<S>& y, const S& stop) = 0;
  virtual void restart() = 0;
  virtual bool shorten() = 0;
  virtual const Counters& counters() const = 0;
  /// Its own multipliers after the last step; null where it has none, or none there.
  virtual const StateVector<S>* lambda() const = 0;
  virtual bool interpolates() const { return false; }
  /// y and lambda at a time of the last step.
  virtual void interpolate(const S& /*t*/, StateVector<S>& /*y*/) {}
  /// What it keeps from step to step, as numbers (memory.hpp); none where it keeps nothing or begins anew.
  virtual std::vector<double> memory() { return {}; }
  /// Begins at a state with the memory of another of its kind, given steps to `stop`. Throws a
  /// std::invalid_argument where the memory is none of such a method.
  virtual void recall(AnySystem<S>& /*system*/, const S& /*t*/, const StateVector<S>& /*y*/,
                      const S& /*stop*/, const std::vector<double>& /*memory*/) {}
};

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

template <class S, Method<AnySystem<S>> M>
std::unique_ptr<AnyMethod<S>> adapt(M method) {
  return std::make_unique<MethodAdapter<S, M>>(std::move(method));
}

}  // namespace trivium::integrators
