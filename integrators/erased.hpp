#pragma once
/// Systems and methods behind one virtual call for each right side or step: methods are then compiled once,
/// not once a formulation.

#include <memory>
#include <string>
#include <utility>

#include "integrators/integrate.hpp"

namespace trivium::integrators {

/// Any FirstOrderSystem or ConstrainedSystem.
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
  virtual bool cross(const S& before, const S& t, Flat<S>& y) = 0;
  virtual std::string suspect(const S& t, const Flat<S>& y) = 0;

  // of a ConstrainedSystem
  virtual int position_size() const = 0;
  virtual int velocity_size() const = 0;
  virtual int multipliers() const = 0;
  virtual void accelerations(const S& t, const Flat<S>& y, Flat<S>& v_dot, Flat<S>& lambda) = 0;
  virtual void displace(const Flat<S>& from, const Flat<S>& displacement, Flat<S>& y) const = 0;
  virtual void displacement(const Flat<S>& from, const Flat<S>& to, Flat<S>& displacement) const = 0;
  virtual void displacement_rate(const Flat<S>& displacement, const Flat<S>& v, Flat<S>& rate) const = 0;
  virtual void position_rate(const Flat<S>& y, const Flat<S>& v, Flat<S>& rate) const = 0;
  virtual void position_sizes(const Flat<S>& y, Flat<S>& sizes) const = 0;
  virtual bool constrain(const S& share, Flat<S>& y, Flat<S>& v_dot) const = 0;
  virtual void constrain_velocity(const S& share, const Flat<S>& y, Flat<S>& v_dot) const = 0;
  virtual bool inertia_is_constant() const = 0;
  virtual void inertia_force(const Flat<S>& y, const Flat<S>& v_dot, Flat<S>& force) = 0;
  virtual void applied_force(const S& t, const Flat<S>& y, Flat<S>& force) = 0;
  virtual S balance(const S& t, const Flat<S>& y, const Flat<S>& force, const Flat<S>& lambda) = 0;
  virtual S position_rows(const S& t, const Flat<S>& y) = 0;
  virtual S velocity_rows() = 0;
  virtual S relative_row_violation() const = 0;
  virtual std::string least_met_row() const = 0;
  virtual void select(int number) = 0;
  virtual void factor(const S& velocity_share, const S& position_share) = 0;
  virtual void newton(const S& share, Flat<S>& v_dot, Flat<S>& lambda) = 0;
  virtual void project(const S& share, Flat<S>& x) = 0;
  virtual void impulse(const Flat<S>& force, Flat<S>& x, Flat<S>& mu) = 0;
  virtual void take_rows(Flat<S>& rows) const = 0;
  virtual void take_imbalance(Flat<S>& left) const = 0;
  virtual void solve(const Flat<S>& left, const Flat<S>& rows, Flat<S>& x, Flat<S>& mu) = 0;
  virtual void solve(const Flat<S>& left, const Flat<S>& rows, const Flat<S>& slack, Flat<S>& x, Flat<S>& mu,
                     Flat<S>& stretch) = 0;
  virtual void take_force(const Flat<S>& force, Flat<S>& left) = 0;
  virtual void solve_force(const Flat<S>& force, Flat<S>& x, Flat<S>& mu) = 0;
  virtual void take_internal_rows(const Flat<S>& v_dot, Flat<S>& left) const = 0;
  virtual void solve_internal_rows(const Flat<S>& y, const Flat<S>& left, Flat<S>& x) = 0;
  virtual bool has_springs() const = 0;
  virtual void spring_constants(Flat<S>& stiffness, Flat<S>& damping) const = 0;
  virtual S work_rate(const Flat<S>& lambda) = 0;
};

/// A system that is no ConstrainedSystem refuses what is asked of one.
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
  bool cross(const S& before, const S& t, Flat<S>& y) override { return system_.cross(before, t, y); }
  std::string suspect(const S& t, const Flat<S>& y) override { return system_.suspect(t, y); }

  int position_size() const override {
    return constrained([](const auto& system) { return system.position_size(); });
  }
  int velocity_size() const override {
    return constrained([](const auto& system) { return system.velocity_size(); });
  }
  int multipliers() const override {
    return constrained([](const auto& system) { return system.multipliers(); });
  }
  void accelerations(const S& t, const Flat<S>& y, Flat<S>& v_dot, Flat<S>& lambda) override {
    constrained([&](auto& system) { system.accelerations(t, y, v_dot, lambda); });
  }
  void displace(const Flat<S>& from, const Flat<S>& displacement, Flat<S>& y) const override {
    constrained([&](const auto& system) { system.displace(from, displacement, y); });
  }
  void displacement(const Flat<S>& from, const Flat<S>& to, Flat<S>& displacement) const override {
    constrained([&](const auto& system) { system.displacement(from, to, displacement); });
  }
  void displacement_rate(const Flat<S>& displacement, const Flat<S>& v, Flat<S>& rate) const override {
    constrained([&](const auto& system) { system.displacement_rate(displacement, v, rate); });
  }
  void position_rate(const Flat<S>& y, const Flat<S>& v, Flat<S>& rate) const override {
    constrained([&](const auto& system) { system.position_rate(y, v, rate); });
  }
  void position_sizes(const Flat<S>& y, Flat<S>& sizes) const override {
    constrained([&](const auto& system) { system.position_sizes(y, sizes); });
  }
  bool constrain(const S& share, Flat<S>& y, Flat<S>& v_dot) const override {
    return constrained([&](const auto& system) { return system.constrain(share, y, v_dot); });
  }
  void constrain_velocity(const S& share, const Flat<S>& y, Flat<S>& v_dot) const override {
    constrained([&](const auto& system) { system.constrain_velocity(share, y, v_dot); });
  }
  bool inertia_is_constant() const override {
    return constrained([](const auto& system) { return system.inertia_is_constant(); });
  }
  void applied_force(const S& t, const Flat<S>& y, Flat<S>& force) override {
    constrained([&](auto& system) { system.applied_force(t, y, force); });
  }
  void inertia_force(const Flat<S>& y, const Flat<S>& v_dot, Flat<S>& force) override {
    constrained([&](auto& system) { system.inertia_force(y, v_dot, force); });
  }
  S balance(const S& t, const Flat<S>& y, const Flat<S>& force, const Flat<S>& lambda) override {
    return constrained([&](auto& system) { return S(system.balance(t, y, force, lambda)); });
  }
  S position_rows(const S& t, const Flat<S>& y) override {
    return constrained([&](auto& system) { return S(system.position_rows(t, y)); });
  }
  S velocity_rows() override {
    return constrained([](auto& system) { return S(system.velocity_rows()); });
  }
  S relative_row_violation() const override {
    return constrained([](const auto& system) { return S(system.relative_row_violation()); });
  }
  std::string least_met_row() const override {
    return constrained([](const auto& system) { return std::string(system.least_met_row()); });
  }
  void select(int number) override {
    constrained([&](auto& system) { system.select(number); });
  }
  void factor(const S& velocity_share, const S& position_share) override {
    constrained([&](auto& system) { system.factor(velocity_share, position_share); });
  }
  void newton(const S& share, Flat<S>& v_dot, Flat<S>& lambda) override {
    constrained([&](auto& system) { system.newton(share, v_dot, lambda); });
  }
  void project(const S& share, Flat<S>& x) override {
    constrained([&](auto& system) { system.project(share, x); });
  }
  void impulse(const Flat<S>& force, Flat<S>& x, Flat<S>& mu) override {
    constrained([&](auto& system) { system.impulse(force, x, mu); });
  }
  void take_rows(Flat<S>& rows) const override {
    constrained([&](const auto& system) { system.take_rows(rows); });
  }
  void take_imbalance(Flat<S>& left) const override {
    constrained([&](const auto& system) { system.take_imbalance(left); });
  }
  void solve(const Flat<S>& left, const Flat<S>& rows, Flat<S>& x, Flat<S>& mu) override {
    constrained([&](auto& system) { system.solve(left, rows, x, mu); });
  }
  void solve(const Flat<S>& left, const Flat<S>& rows, const Flat<S>& slack, Flat<S>& x, Flat<S>& mu,
             Flat<S>& stretch) override {
    constrained([&](auto& system) { system.solve(left, rows, slack, x, mu, stretch); });
  }
  void take_force(const Flat<S>& force, Flat<S>& left) override {
    constrained([&](auto& system) { system.take_force(force, left); });
  }
  void solve_force(const Flat<S>& force, Flat<S>& x, Flat<S>& mu) override {
    constrained([&](auto& system) { system.solve_force(force, x, mu); });
  }
  void take_internal_rows(const Flat<S>& v_dot, Flat<S>& left) const override {
    constrained([&](const auto& system) { system.take_internal_rows(v_dot, left); });
  }
  void solve_internal_rows(const Flat<S>& y, const Flat<S>& left, Flat<S>& x) override {
    constrained([&](auto& system) { system.solve_internal_rows(y, left, x); });
  }
  bool has_springs() const override {
    return constrained([](const auto& system) { return system.has_springs(); });
  }
  void spring_constants(Flat<S>& stiffness, Flat<S>& damping) const override {
    constrained([&](const auto& system) { system.spring_constants(stiffness, damping); });
  }
  S work_rate(const Flat<S>& lambda) override {
    return constrained([&](auto& system) { return S(system.work_rate(lambda)); });
  }

 private:
  template <class Ask>
  auto constrained(const Ask& ask) const {
    if constexpr (ConstrainedSystem<System>)
      return ask(system_);
    else
      return refuse<decltype(ask(std::declval<AnySystem<S>&>()))>();
  }
  template <class Answer>
  static Answer refuse() {
    throw UsageError("implicit methods need a system with its constraints, and this has none; take dopri5");
  }

  System& system_;
};

static_assert(ConstrainedSystem<AnySystem<double>>);

/// Any Method on AnySystem.
template <class S>
class AnyMethod {
 public:
  virtual ~AnyMethod() = default;
  virtual void step(AnySystem<S>& system, S& t, Flat<S>& y, const S& stop) = 0;
  virtual void restart() = 0;
  virtual bool shorten() = 0;
  virtual const Counters& counters() const = 0;
  /// Its own multipliers after the last step; null where it has none, or none there.
  virtual const Flat<S>* lambda() const = 0;
  virtual bool interpolates() const { return false; }
  /// y and lambda at a time of the last step.
  virtual void interpolate(const S& /*t*/, Flat<S>& /*y*/) {}
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
  const Flat<S>* lambda() const override {
    if constexpr (requires { method_.lambda(); })
      return method_.lambda();
    else
      return nullptr;
  }

 private:
  M method_;
};

static_assert(Method<AnyMethod<double>, AnySystem<double>>);

}  // namespace trivium::integrators
