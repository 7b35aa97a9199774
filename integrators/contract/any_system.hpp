#pragma once
/// Any system behind virtual calls, one for each right side or solve. Methods are then compiled once for each
/// scalar, not once for each formulation.

#include <string>
#include <utility>

#include "integrators/contract/constrained_system.hpp"
#include "integrators/contract/errors.hpp"

namespace trivium::integrators {

/// Any FirstOrderSystem or ConstrainedSystem.
template <class S>
class AnySystem {
 public:
  using Scalar = S;

  virtual ~AnySystem() = default;
  virtual int size() const = 0;
  virtual StateVector<S> start() const = 0;
  virtual void derivative(const S& t, const StateVector<S>& y, StateVector<S>& y_dot) = 0;
  virtual S position_violation(const S& t, const StateVector<S>& y) = 0;
  virtual S velocity_violation(const S& t, const StateVector<S>& y) = 0;
  virtual S relative_violation() const = 0;
  virtual bool projection_is_too_large(const StateVector<S>& before, const StateVector<S>& stepped,
                                       const StateVector<S>& projected) = 0;
  virtual S longest_step(const S& t, const StateVector<S>& y) = 0;
  virtual void correct_positions(StateVector<S>& y, bool factor) = 0;
  virtual void correct_velocities(StateVector<S>& y, bool factor) = 0;
  virtual void normalise(StateVector<S>& y) = 0;
  virtual std::string worst_row() const = 0;
  virtual bool accept_state(const S& t, StateVector<S>& y) = 0;
  virtual bool pass_discontinuity(const S& before, const S& t, StateVector<S>& y) = 0;
  virtual std::string diagnose(const S& t, const StateVector<S>& y) = 0;

  // of a ConstrainedSystem
  virtual int position_size() const = 0;
  virtual int velocity_size() const = 0;
  virtual int multipliers() const = 0;
  virtual void accelerations(const S& t, const StateVector<S>& y, StateVector<S>& v_dot,
                             StateVector<S>& lambda) = 0;
  virtual void displace(const StateVector<S>& from, const StateVector<S>& displacement,
                        StateVector<S>& y) const = 0;
  virtual void displacement(const StateVector<S>& from, const StateVector<S>& to,
                            StateVector<S>& displacement) const = 0;
  virtual void displacement_rate(const StateVector<S>& displacement, const StateVector<S>& v,
                                 StateVector<S>& rate) const = 0;
  virtual void position_rate(const StateVector<S>& y, const StateVector<S>& v,
                             StateVector<S>& rate) const = 0;
  virtual void position_sizes(const StateVector<S>& y, StateVector<S>& sizes) const = 0;
  virtual bool normalise_step(const S& share, StateVector<S>& y, StateVector<S>& v_dot) const = 0;
  virtual void normalise_step_velocity(const S& share, const StateVector<S>& y,
                                       StateVector<S>& v_dot) const = 0;
  virtual bool inertia_is_constant() const = 0;
  virtual void inertia_force(const StateVector<S>& y, const StateVector<S>& v_dot, StateVector<S>& force) = 0;
  virtual void applied_force(const S& t, const StateVector<S>& y, StateVector<S>& force) = 0;
  virtual S residual(const S& t, const StateVector<S>& y, const StateVector<S>& force,
                     const StateVector<S>& lambda) = 0;
  virtual S position_rows(const S& t, const StateVector<S>& y) = 0;
  virtual S velocity_rows() = 0;
  virtual S relative_row_violation() const = 0;
  virtual std::string least_met_row() const = 0;
  virtual void select(int number) = 0;
  virtual void factor(const S& velocity_share, const S& position_share) = 0;
  virtual void newton(const S& share, StateVector<S>& v_dot, StateVector<S>& lambda) = 0;
  virtual void project(const S& share, StateVector<S>& x) = 0;
  virtual void velocity_projection(const StateVector<S>& force, StateVector<S>& x, StateVector<S>& mu) = 0;
  virtual void row_residual(StateVector<S>& rows) const = 0;
  virtual void force_residual(StateVector<S>& left) const = 0;
  virtual void solve(const StateVector<S>& left, const StateVector<S>& rows, StateVector<S>& x,
                     StateVector<S>& mu) = 0;
  virtual void solve(const StateVector<S>& left, const StateVector<S>& rows, const StateVector<S>& slack,
                     StateVector<S>& x, StateVector<S>& mu, StateVector<S>& stretch) = 0;
  virtual void take_force(const StateVector<S>& force, StateVector<S>& left) = 0;
  virtual void solve_force(const StateVector<S>& force, StateVector<S>& x, StateVector<S>& mu) = 0;
  virtual void take_internal_rows(const StateVector<S>& v_dot, StateVector<S>& left) const = 0;
  virtual void solve_internal_rows(const StateVector<S>& y, const StateVector<S>& left,
                                   StateVector<S>& x) = 0;
  virtual bool has_springs() const = 0;
  virtual void spring_constants(StateVector<S>& stiffness, StateVector<S>& damping) const = 0;
  virtual S work_rate(const StateVector<S>& lambda) = 0;
};

/// A system that is no ConstrainedSystem refuses what is asked of one.
template <FirstOrderSystem System>
class SystemAdapter final : public AnySystem<typename System::Scalar> {
 public:
  using S = typename System::Scalar;

  /// The system must outlive this.
  explicit SystemAdapter(System& system) : system_(system) {}

  int size() const override { return system_.size(); }
  StateVector<S> start() const override { return system_.start(); }
  void derivative(const S& t, const StateVector<S>& y, StateVector<S>& y_dot) override {
    system_.derivative(t, y, y_dot);
  }
  S position_violation(const S& t, const StateVector<S>& y) override {
    return system_.position_violation(t, y);
  }
  S velocity_violation(const S& t, const StateVector<S>& y) override {
    return system_.velocity_violation(t, y);
  }
  S relative_violation() const override { return system_.relative_violation(); }
  bool projection_is_too_large(const StateVector<S>& before, const StateVector<S>& stepped,
                               const StateVector<S>& projected) override {
    return system_.projection_is_too_large(before, stepped, projected);
  }
  S longest_step(const S& t, const StateVector<S>& y) override { return system_.longest_step(t, y); }
  void correct_positions(StateVector<S>& y, bool factor) override { system_.correct_positions(y, factor); }
  void correct_velocities(StateVector<S>& y, bool factor) override { system_.correct_velocities(y, factor); }
  void normalise(StateVector<S>& y) override { system_.normalise(y); }
  std::string worst_row() const override { return system_.worst_row(); }
  bool accept_state(const S& t, StateVector<S>& y) override { return system_.accept_state(t, y); }
  bool pass_discontinuity(const S& before, const S& t, StateVector<S>& y) override {
    return system_.pass_discontinuity(before, t, y);
  }
  std::string diagnose(const S& t, const StateVector<S>& y) override { return system_.diagnose(t, y); }

  int position_size() const override {
    return constrained([](const auto& system) { return system.position_size(); });
  }
  int velocity_size() const override {
    return constrained([](const auto& system) { return system.velocity_size(); });
  }
  int multipliers() const override {
    return constrained([](const auto& system) { return system.multipliers(); });
  }
  void accelerations(const S& t, const StateVector<S>& y, StateVector<S>& v_dot,
                     StateVector<S>& lambda) override {
    constrained([&](auto& system) { system.accelerations(t, y, v_dot, lambda); });
  }
  void displace(const StateVector<S>& from, const StateVector<S>& displacement,
                StateVector<S>& y) const override {
    constrained([&](const auto& system) { system.displace(from, displacement, y); });
  }
  void displacement(const StateVector<S>& from, const StateVector<S>& to,
                    StateVector<S>& displacement) const override {
    constrained([&](const auto& system) { system.displacement(from, to, displacement); });
  }
  void displacement_rate(const StateVector<S>& displacement, const StateVector<S>& v,
                         StateVector<S>& rate) const override {
    constrained([&](const auto& system) { system.displacement_rate(displacement, v, rate); });
  }
  void position_rate(const StateVector<S>& y, const StateVector<S>& v, StateVector<S>& rate) const override {
    constrained([&](const auto& system) { system.position_rate(y, v, rate); });
  }
  void position_sizes(const StateVector<S>& y, StateVector<S>& sizes) const override {
    constrained([&](const auto& system) { system.position_sizes(y, sizes); });
  }
  bool normalise_step(const S& share, StateVector<S>& y, StateVector<S>& v_dot) const override {
    return constrained([&](const auto& system) { return system.normalise_step(share, y, v_dot); });
  }
  void normalise_step_velocity(const S& share, const StateVector<S>& y,
                               StateVector<S>& v_dot) const override {
    constrained([&](const auto& system) { system.normalise_step_velocity(share, y, v_dot); });
  }
  bool inertia_is_constant() const override {
    return constrained([](const auto& system) { return system.inertia_is_constant(); });
  }
  void applied_force(const S& t, const StateVector<S>& y, StateVector<S>& force) override {
    constrained([&](auto& system) { system.applied_force(t, y, force); });
  }
  void inertia_force(const StateVector<S>& y, const StateVector<S>& v_dot, StateVector<S>& force) override {
    constrained([&](auto& system) { system.inertia_force(y, v_dot, force); });
  }
  S residual(const S& t, const StateVector<S>& y, const StateVector<S>& force,
             const StateVector<S>& lambda) override {
    return constrained([&](auto& system) { return S(system.residual(t, y, force, lambda)); });
  }
  S position_rows(const S& t, const StateVector<S>& y) override {
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
  void newton(const S& share, StateVector<S>& v_dot, StateVector<S>& lambda) override {
    constrained([&](auto& system) { system.newton(share, v_dot, lambda); });
  }
  void project(const S& share, StateVector<S>& x) override {
    constrained([&](auto& system) { system.project(share, x); });
  }
  void velocity_projection(const StateVector<S>& force, StateVector<S>& x, StateVector<S>& mu) override {
    constrained([&](auto& system) { system.velocity_projection(force, x, mu); });
  }
  void row_residual(StateVector<S>& rows) const override {
    constrained([&](const auto& system) { system.row_residual(rows); });
  }
  void force_residual(StateVector<S>& left) const override {
    constrained([&](const auto& system) { system.force_residual(left); });
  }
  void solve(const StateVector<S>& left, const StateVector<S>& rows, StateVector<S>& x,
             StateVector<S>& mu) override {
    constrained([&](auto& system) { system.solve(left, rows, x, mu); });
  }
  void solve(const StateVector<S>& left, const StateVector<S>& rows, const StateVector<S>& slack,
             StateVector<S>& x, StateVector<S>& mu, StateVector<S>& stretch) override {
    constrained([&](auto& system) { system.solve(left, rows, slack, x, mu, stretch); });
  }
  void take_force(const StateVector<S>& force, StateVector<S>& left) override {
    constrained([&](auto& system) { system.take_force(force, left); });
  }
  void solve_force(const StateVector<S>& force, StateVector<S>& x, StateVector<S>& mu) override {
    constrained([&](auto& system) { system.solve_force(force, x, mu); });
  }
  void take_internal_rows(const StateVector<S>& v_dot, StateVector<S>& left) const override {
    constrained([&](const auto& system) { system.take_internal_rows(v_dot, left); });
  }
  void solve_internal_rows(const StateVector<S>& y, const StateVector<S>& left, StateVector<S>& x) override {
    constrained([&](auto& system) { system.solve_internal_rows(y, left, x); });
  }
  bool has_springs() const override {
    return constrained([](const auto& system) { return system.has_springs(); });
  }
  void spring_constants(StateVector<S>& stiffness, StateVector<S>& damping) const override {
    constrained([&](const auto& system) { system.spring_constants(stiffness, damping); });
  }
  S work_rate(const StateVector<S>& lambda) override {
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

}  // namespace trivium::integrators
