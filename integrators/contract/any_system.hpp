#pragma once
/// Type erasure of systems: AnySystem is the interface of any system, with one virtual call per right side or
/// solve. Methods are compiled once per scalar this way, and not once per formulation.

#include <fmt/format.h>

#include <string>
#include <type_traits>
#include <utility>

#include "integrators/contract/any_value.hpp"
#include "integrators/contract/constrained_system.hpp"
#include "integrators/contract/errors.hpp"

namespace trivium::integrators {

/// Any FirstOrderSystem. The functions are those of the concepts that the comments below name. A function of
/// another concept than FirstOrderSystem throws a UsageError if the system behind the interface does not
/// satisfy it.
template <class S>
class AnySystem {
 public:
  using Scalar = S;
  using Evaluation = AnyEvaluation;
  using Factors = AnyFactors;

  virtual ~AnySystem() = default;
  // FirstOrderSystem
  virtual int size() const = 0;
  virtual StateVector<S> start() const = 0;
  virtual void derivative(const S& t, const StateVector<S>& y, StateVector<S>& y_dot) = 0;
  virtual Violation<S> position_violation(const S& t, const StateVector<S>& y) = 0;
  virtual Violation<S> velocity_violation(const S& t, const StateVector<S>& y) = 0;
  virtual std::string row_name(int row) const = 0;
  virtual bool projection_is_too_large(const StateVector<S>& before, const StateVector<S>& stepped,
                                       const StateVector<S>& projected) = 0;
  virtual S longest_step(const S& t, const StateVector<S>& y) = 0;
  virtual void correct_positions(const S& t, StateVector<S>& y, bool factor) = 0;
  virtual void correct_velocities(const S& t, StateVector<S>& y, bool factor) = 0;
  virtual void normalise(StateVector<S>& y) = 0;
  virtual bool accept_state(const S& t, StateVector<S>& y) = 0;
  virtual bool pass_discontinuity(const S& before, const S& t, StateVector<S>& y) = 0;
  virtual std::string most_accelerated(const S& t, const StateVector<S>& y) = 0;
  virtual std::string diagnose(const S& t, const StateVector<S>& y, const S& step) = 0;

  // HasDisplacements
  virtual int position_size() const = 0;
  virtual int velocity_size() const = 0;
  virtual void displace(const StateVector<S>& from, const StateVector<S>& displacement,
                        StateVector<S>& to) const = 0;
  virtual void displacement(const StateVector<S>& from, const StateVector<S>& to,
                            StateVector<S>& displacement) const = 0;
  virtual void displacement_rate(const StateVector<S>& displacement, const StateVector<S>& v,
                                 StateVector<S>& rate) const = 0;
  virtual void position_rate(const StateVector<S>& y, const StateVector<S>& v,
                             StateVector<S>& rate) const = 0;
  virtual void position_sizes(const StateVector<S>& y, StateVector<S>& sizes) const = 0;

  // HasResidual
  virtual void evaluate(const S& t, const StateVector<S>& y, AnyEvaluation& at) = 0;
  virtual int multipliers() const = 0;
  virtual void accelerations(const S& t, const StateVector<S>& y, StateVector<S>& v_dot,
                             StateVector<S>& lambda) = 0;
  virtual bool inertia_is_constant() const = 0;
  virtual void inertia_force(const AnyEvaluation& at, const StateVector<S>& x, StateVector<S>& force) = 0;
  virtual void applied_force(const AnyEvaluation& at, StateVector<S>& force) = 0;
  virtual S residual(const AnyEvaluation& at, const StateVector<S>& force, const StateVector<S>& lambda,
                     StateVector<S>& left) = 0;
  virtual Violation<S> position_rows(const AnyEvaluation& at, StateVector<S>& rows) = 0;
  virtual Violation<S> velocity_rows(const AnyEvaluation& at, StateVector<S>& rows) = 0;
  virtual void clear_dependent(StateVector<S>& lambda) = 0;
  virtual S work_rate(const AnyEvaluation& at, const StateVector<S>& lambda) = 0;

  // HasNewtonMatrix
  virtual void factor(const AnyEvaluation& at, const Shares<S>& shares, AnyFactors& factors) = 0;
  virtual void solve(const AnyFactors& factors, const AnyEvaluation& at, const StateVector<S>& left,
                     const StateVector<S>& rows, StateVector<S>& x, StateVector<S>& mu) = 0;
  virtual void reduce(const AnyFactors& factors, const StateVector<S>& force, StateVector<S>& left) = 0;
  virtual void inertia_force(const AnyFactors& factors, const StateVector<S>& x, StateVector<S>& force) = 0;

  // HasInternalRows
  virtual bool normalise_step(const S& share, StateVector<S>& y, StateVector<S>& v_dot) = 0;
  virtual void normalise_step_velocity(const S& share, const StateVector<S>& y, StateVector<S>& v_dot) = 0;
  virtual void internal_residual(const AnyEvaluation& at, const StateVector<S>& v_dot,
                                 StateVector<S>& left) = 0;
  virtual void solve_internal_rows(const AnyEvaluation& at, const StateVector<S>& left,
                                   StateVector<S>& x) = 0;

  // HasSprings
  virtual int springs() const = 0;
  virtual void spring_constants(StateVector<S>& stiffness, StateVector<S>& damping) = 0;
  virtual void solve(const AnyFactors& factors, const AnyEvaluation& at, const StateVector<S>& left,
                     const StateVector<S>& rows, const StateVector<S>& slack, StateVector<S>& x,
                     StateVector<S>& mu, StateVector<S>& stretch) = 0;
};

/// AnySystem for a given System. A function of a group that the system does not have throws a UsageError.
template <FirstOrderSystem System>
class SystemAdapter final : public AnySystem<typename System::Scalar> {
 public:
  using S = typename System::Scalar;

  /// Keeps a reference: the system must outlive the adapter.
  explicit SystemAdapter(System& system) : system_(system) {}

  int size() const override { return system_.size(); }
  StateVector<S> start() const override { return system_.start(); }
  void derivative(const S& t, const StateVector<S>& y, StateVector<S>& y_dot) override {
    system_.derivative(t, y, y_dot);
  }
  Violation<S> position_violation(const S& t, const StateVector<S>& y) override {
    return system_.position_violation(t, y);
  }
  Violation<S> velocity_violation(const S& t, const StateVector<S>& y) override {
    return system_.velocity_violation(t, y);
  }
  std::string row_name(int row) const override { return system_.row_name(row); }
  bool projection_is_too_large(const StateVector<S>& before, const StateVector<S>& stepped,
                               const StateVector<S>& projected) override {
    return system_.projection_is_too_large(before, stepped, projected);
  }
  S longest_step(const S& t, const StateVector<S>& y) override { return system_.longest_step(t, y); }
  void correct_positions(const S& t, StateVector<S>& y, bool factor) override {
    system_.correct_positions(t, y, factor);
  }
  void correct_velocities(const S& t, StateVector<S>& y, bool factor) override {
    system_.correct_velocities(t, y, factor);
  }
  void normalise(StateVector<S>& y) override { system_.normalise(y); }
  bool accept_state(const S& t, StateVector<S>& y) override { return system_.accept_state(t, y); }
  bool pass_discontinuity(const S& before, const S& t, StateVector<S>& y) override {
    return system_.pass_discontinuity(before, t, y);
  }
  std::string most_accelerated(const S& t, const StateVector<S>& y) override {
    return system_.most_accelerated(t, y);
  }
  std::string diagnose(const S& t, const StateVector<S>& y, const S& step) override {
    return system_.diagnose(t, y, step);
  }

  int position_size() const override {
    return ask_of<Group::displacements, int>([&](auto& system) { return system.position_size(); });
  }
  int velocity_size() const override {
    return ask_of<Group::displacements, int>([&](auto& system) { return system.velocity_size(); });
  }
  void displace(const StateVector<S>& from, const StateVector<S>& displacement,
                StateVector<S>& to) const override {
    ask_of<Group::displacements>([&](auto& system) { system.displace(from, displacement, to); });
  }
  void displacement(const StateVector<S>& from, const StateVector<S>& to,
                    StateVector<S>& displacement) const override {
    ask_of<Group::displacements>([&](auto& system) { system.displacement(from, to, displacement); });
  }
  void displacement_rate(const StateVector<S>& displacement, const StateVector<S>& v,
                         StateVector<S>& rate) const override {
    ask_of<Group::displacements>([&](auto& system) { system.displacement_rate(displacement, v, rate); });
  }
  void position_rate(const StateVector<S>& y, const StateVector<S>& v, StateVector<S>& rate) const override {
    ask_of<Group::displacements>([&](auto& system) { system.position_rate(y, v, rate); });
  }
  void position_sizes(const StateVector<S>& y, StateVector<S>& sizes) const override {
    ask_of<Group::displacements>([&](auto& system) { system.position_sizes(y, sizes); });
  }

  void evaluate(const S& t, const StateVector<S>& y, AnyEvaluation& at) override {
    ask_of<Group::residual>([&](auto& system) { system.evaluate(t, y, own(at)); });
  }
  int multipliers() const override {
    return ask_of<Group::residual, int>([&](auto& system) { return system.multipliers(); });
  }
  void accelerations(const S& t, const StateVector<S>& y, StateVector<S>& v_dot,
                     StateVector<S>& lambda) override {
    ask_of<Group::residual>([&](auto& system) { system.accelerations(t, y, v_dot, lambda); });
  }
  bool inertia_is_constant() const override {
    return ask_of<Group::residual, bool>([&](auto& system) { return system.inertia_is_constant(); });
  }
  void inertia_force(const AnyEvaluation& at, const StateVector<S>& x, StateVector<S>& force) override {
    ask_of<Group::residual>([&](auto& system) { system.inertia_force(own(at), x, force); });
  }
  void applied_force(const AnyEvaluation& at, StateVector<S>& force) override {
    ask_of<Group::residual>([&](auto& system) { system.applied_force(own(at), force); });
  }
  S residual(const AnyEvaluation& at, const StateVector<S>& force, const StateVector<S>& lambda,
             StateVector<S>& left) override {
    return ask_of<Group::residual, S>(
        [&](auto& system) { return S(system.residual(own(at), force, lambda, left)); });
  }
  Violation<S> position_rows(const AnyEvaluation& at, StateVector<S>& rows) override {
    return ask_of<Group::residual, Violation<S>>(
        [&](auto& system) { return system.position_rows(own(at), rows); });
  }
  Violation<S> velocity_rows(const AnyEvaluation& at, StateVector<S>& rows) override {
    return ask_of<Group::residual, Violation<S>>(
        [&](auto& system) { return system.velocity_rows(own(at), rows); });
  }
  void clear_dependent(StateVector<S>& lambda) override {
    ask_of<Group::residual, void>([&](auto& system) { system.clear_dependent(lambda); });
  }
  S work_rate(const AnyEvaluation& at, const StateVector<S>& lambda) override {
    return ask_of<Group::residual, S>([&](auto& system) { return S(system.work_rate(own(at), lambda)); });
  }

  void factor(const AnyEvaluation& at, const Shares<S>& shares, AnyFactors& factors) override {
    ask_of<Group::newton_matrix>([&](auto& system) { system.factor(own(at), shares, own(factors)); });
  }
  void solve(const AnyFactors& factors, const AnyEvaluation& at, const StateVector<S>& left,
             const StateVector<S>& rows, StateVector<S>& x, StateVector<S>& mu) override {
    ask_of<Group::newton_matrix>(
        [&](auto& system) { system.solve(own(factors), own(at), left, rows, x, mu); });
  }
  void reduce(const AnyFactors& factors, const StateVector<S>& force, StateVector<S>& left) override {
    ask_of<Group::newton_matrix>([&](auto& system) { system.reduce(own(factors), force, left); });
  }
  void inertia_force(const AnyFactors& factors, const StateVector<S>& x, StateVector<S>& force) override {
    ask_of<Group::newton_matrix>([&](auto& system) { system.inertia_force(own(factors), x, force); });
  }

  bool normalise_step(const S& share, StateVector<S>& y, StateVector<S>& v_dot) override {
    return ask_of<Group::internal_rows, bool>(
        [&](auto& system) { return system.normalise_step(share, y, v_dot); });
  }
  void normalise_step_velocity(const S& share, const StateVector<S>& y, StateVector<S>& v_dot) override {
    ask_of<Group::internal_rows>([&](auto& system) { system.normalise_step_velocity(share, y, v_dot); });
  }
  void internal_residual(const AnyEvaluation& at, const StateVector<S>& v_dot,
                         StateVector<S>& left) override {
    ask_of<Group::internal_rows>([&](auto& system) { system.internal_residual(own(at), v_dot, left); });
  }
  void solve_internal_rows(const AnyEvaluation& at, const StateVector<S>& left, StateVector<S>& x) override {
    ask_of<Group::internal_rows>([&](auto& system) { system.solve_internal_rows(own(at), left, x); });
  }

  int springs() const override {
    return ask_of<Group::springs, int>([&](auto& system) { return system.springs(); });
  }
  void spring_constants(StateVector<S>& stiffness, StateVector<S>& damping) override {
    ask_of<Group::springs>([&](auto& system) { system.spring_constants(stiffness, damping); });
  }
  void solve(const AnyFactors& factors, const AnyEvaluation& at, const StateVector<S>& left,
             const StateVector<S>& rows, const StateVector<S>& slack, StateVector<S>& x, StateVector<S>& mu,
             StateVector<S>& stretch) override {
    ask_of<Group::springs>(
        [&](auto& system) { system.solve(own(factors), own(at), left, rows, slack, x, mu, stretch); });
  }

 private:
  enum class Group { displacements, residual, newton_matrix, internal_rows, springs };
  static constexpr bool has(Group group) {
    switch (group) {
      case Group::displacements:
        return HasDisplacements<System>;
      case Group::residual:
        return HasResidual<System>;
      case Group::newton_matrix:
        return HasNewtonMatrix<System>;
      case Group::internal_rows:
        return HasInternalRows<System>;
      case Group::springs:
        return HasSprings<System>;
    }
    return false;
  }
  template <Group group, class Answer = void, class Ask>
  Answer ask_of(const Ask& ask) const {
    if constexpr (has(group))
      return ask(system_);
    else
      refuse(group);
  }
  [[noreturn]] static void refuse(Group group) {
    static constexpr const char* concepts[] = {"HasDisplacements", "HasResidual", "HasNewtonMatrix",
                                               "HasInternalRows", "HasSprings"};
    throw UsageError(
        fmt::format("the method needs functions ({}) that this model does not provide; take an explicit "
                    "method such as dopri5",
                    concepts[static_cast<int>(group)]));
  }

  // the contents of the box, in the type of the system; for a system without this type, the box itself
  template <class Value>
  static decltype(auto) own(Value& value) {
    if constexpr (std::is_same_v<std::remove_const_t<Value>, AnyEvaluation>) {
      if constexpr (HasResidual<System>)
        return value.template as<typename System::Evaluation>();
      else
        return (value);
    } else {
      if constexpr (HasNewtonMatrix<System>)
        return value.template as<typename System::Factors>();
      else
        return (value);
    }
  }

  System& system_;
};

static_assert(ConstrainedSystem<AnySystem<double>>);

}  // namespace trivium::integrators
