#pragma once
/// Systems and methods behind one virtual call for each right side or step: methods are then compiled once,
/// not once a formulation.

#include <memory>
#include <string>

#include "integrators/integrate.hpp"

namespace trivium::integrators {

/// Any FirstOrderSystem.
template <class S>
class AnySystem {
 public:
  using Scalar = S;

  virtual ~AnySystem() = default;
  virtual int size() const = 0;
  virtual Flat<S> start() const = 0;
  virtual void derivative(const S& t, const Flat<S>& y, Flat<S>& y_dot) = 0;
  virtual S position_violation(const S& t, const Flat<S>& y) = 0;
  virtual S velocity_violation(const S& t, const Flat<S>& y) = 0;
  virtual S relative_violation() const = 0;
  virtual bool strays(const Flat<S>& before, const Flat<S>& stepped, const Flat<S>& projected) = 0;
  virtual S longest_step(const S& t, const Flat<S>& y) = 0;
  virtual void correct_positions(Flat<S>& y, bool factor) = 0;
  virtual void correct_velocities(Flat<S>& y, bool factor) = 0;
  virtual void meet_internal(Flat<S>& y) = 0;
  virtual std::string worst_row() const = 0;
  virtual bool settle(const S& t, Flat<S>& y) = 0;
  virtual std::string suspect(const S& t, const Flat<S>& y) = 0;
};

template <FirstOrderSystem System>
class Erased final : public AnySystem<typename System::Scalar> {
 public:
  using S = typename System::Scalar;

  /// The system must outlive this.
  explicit Erased(System& system) : system_(system) {}

  int size() const override { return system_.size(); }
  Flat<S> start() const override { return system_.start(); }
  void derivative(const S& t, const Flat<S>& y, Flat<S>& y_dot) override { system_.derivative(t, y, y_dot); }
  S position_violation(const S& t, const Flat<S>& y) override { return system_.position_violation(t, y); }
  S velocity_violation(const S& t, const Flat<S>& y) override { return system_.velocity_violation(t, y); }
  S relative_violation() const override { return system_.relative_violation(); }
  bool strays(const Flat<S>& before, const Flat<S>& stepped, const Flat<S>& projected) override {
    return system_.strays(before, stepped, projected);
  }
  S longest_step(const S& t, const Flat<S>& y) override { return system_.longest_step(t, y); }
  void correct_positions(Flat<S>& y, bool factor) override { system_.correct_positions(y, factor); }
  void correct_velocities(Flat<S>& y, bool factor) override { system_.correct_velocities(y, factor); }
  void meet_internal(Flat<S>& y) override { system_.meet_internal(y); }
  std::string worst_row() const override { return system_.worst_row(); }
  bool settle(const S& t, Flat<S>& y) override { return system_.settle(t, y); }
  std::string suspect(const S& t, const Flat<S>& y) override { return system_.suspect(t, y); }

 private:
  System& system_;
};

static_assert(FirstOrderSystem<AnySystem<double>>);

/// Any Method on AnySystem.
template <class S>
class AnyMethod {
 public:
  virtual ~AnyMethod() = default;
  virtual void step(AnySystem<S>& system, S& t, Flat<S>& y, const S& stop) = 0;
  virtual void restart() = 0;
  virtual bool shorten() = 0;
  virtual const Counters& counters() const = 0;
};

template <class S, class M>
class ErasedMethod final : public AnyMethod<S> {
 public:
  explicit ErasedMethod(M method) : method_(std::move(method)) {}
  void step(AnySystem<S>& system, S& t, Flat<S>& y, const S& stop) override {
    method_.step(system, t, y, stop);
  }
  void restart() override { method_.restart(); }
  bool shorten() override { return method_.shorten(); }
  const Counters& counters() const override { return method_.counters(); }

 private:
  M method_;
};

static_assert(Method<AnyMethod<double>, AnySystem<double>>);

}  // namespace trivium::integrators
