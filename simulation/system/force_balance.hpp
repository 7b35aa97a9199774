#pragma once
/// The residual of the equations of motion, body by body, and its size relative to the acting forces:
///
///     residual = Q - force - Phi_q^T lambda,   where `force` stands for M v'
///
/// This file decides which part of a residual is rounding. Four sources of rounding are not visible in the
/// resulting forces on a body: stiff springs whose forces cancel, constraint forces that cancel, as on a body
/// that several pins hold against a torque, moment arms that are differences of positions far from the
/// origin, and terms of the size |J| |omega|^2 that cancel, as on a wheel that turns steadily without a load.
/// Their rounding is subtracted from the residual.

#include <algorithm>
#include <limits>
#include <vector>

#include "simulation/system/evaluation.hpp"

namespace trivium {

/// Computes the residual of every body at an evaluated state, and the largest relative residual.
template <Formulation F>
class ForceBalance {
 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;
  using Layout = StateLayout<F>;

  /// Mechanism and plan must outlive this object.
  ForceBalance(const MechanismOf<F>&&, const EliminationPlan&) = delete;
  ForceBalance(const MechanismOf<F>&, const EliminationPlan&&) = delete;
  ForceBalance(const MechanismOf<F>& mechanism, const EliminationPlan& plan)
      : mechanism_(mechanism), plan_(plan), on_(mechanism.nb() + 1), size_(mechanism.nb() + 1) {}

  /// Writes the reduced residual of every body into `left`. Returns the largest residual of a body relative
  /// to the largest forces or moments on a body of its component [-]; the largest finite number if a residual
  /// is NaN or infinite.
  S measure(const EvaluatedModel<F>& at, const std::vector<Wrench<S>>& wrenches, const StateVector& force,
            const StateVector& lambda, StateVector& left) {
    apply_multipliers(at.assembly, lambda);
    left.resize(Layout::velocities * mechanism_.nb());
    if constexpr (Layout::velocities > 6) left.setZero();
    const ConstraintViolation<S>& components = at.violation;
    const auto of_springs = [&](int b) {
      return at.spring_sizes.empty() ? typename SpringRows<F>::SpringSize{} : at.spring_sizes[b];
    };
    for (BalanceSize& size : size_) size = {};
    // machine epsilon, twice the unit roundoff: the forces and arms below come from several roundings
    const S u = std::numeric_limits<S>::epsilon();
    S all_left(0);
    for (int b = 0; b < mechanism_.nb(); ++b) {
      const typename F::Reduced& body = at.body()[b];
      const Vector3<S> inertia = F::reduced(body, Layout::q_of(force, b));
      const Vector3<S> applied = F::reduced(body, F::applied_force(body, wrenches[b].n_bar) +
                                                      F::velocity_force(body, mechanism_.bodies[b].inertia));
      const Vector3<S> held_r = unpadded<S>(on_[b].r), held_x = unpadded<S>(on_[b].x);
      const Vector3<S> left_r = wrenches[b].F - Layout::r_of(force, b) - held_r,
                       left_x = applied - inertia - held_x;
      Layout::of(left, b).template head<6>() << left_r, left_x;
      const auto norm = [&](const Vector3<S>& x) { return F::moment(body, x).norm(); };
      BalanceSize& size = size_[components.component_of(b)];
      // std::max may drop a NaN; the sum of squares all_left keeps it
      size.force =
          std::max(size.force, S(wrenches[b].F.norm() + Layout::r_of(force, b).norm() + held_r.norm()));
      size.moment = std::max(size.moment, S(norm(applied) + norm(inertia) + norm(held_x)));
      all_left += left_r.squaredNorm() + left_x.squaredNorm();
      // the forces of springs may cancel; their rounding is then not small relative to the sum
      size.force_left = std::max(size.force_left, S(left_r.norm() - u * of_springs(b).force));
      // 8: products of four factors, as in r-p, round several times
      const S turning = 8 * mechanism_.bodies[b].inertia.norm() * body.omega_bar.squaredNorm();
      size.moment_left = std::max(size.moment_left, S(norm(left_x) - u * (of_springs(b).moment + turning)));
    }
    if (!(all_left <= std::numeric_limits<S>::max())) return std::numeric_limits<S>::max();
    // 1000: constraint forces that are hardly larger than the sums have no more rounding than these
    const S multiplier = lambda.size() > 0 ? S(lambda.cwiseAbs().maxCoeff()) : S(0);
    if (std::any_of(size_.begin(), size_.end(), [&](const BalanceSize& size) {
          return size.force_left > S(0) && size.force < multiplier / 1000;
        }))
      measure_multipliers(components, lambda);
    S largest(0);
    for (int b = 0; b < mechanism_.nb(); ++b) {
      const BalanceSize& size = size_[components.component_of(b)];
      const auto take_share = [&](const S& part, const S& whole) {
        if (part > largest * whole) largest = part / whole;
      };
      take_share(S(size.force_left - u * size.multipliers), size.force);
      // moment arms are differences of positions up to length_of, with a rounding of epsilon length_of
      take_share(S(size.moment_left - u * components.length_of(b) * (size.force + size.multipliers)),
                 S(size.moment + components.arm_of(b) * size.force));
    }
    return largest;
  }

 private:
  /// Sums the magnitudes of the multipliers of each component.
  void measure_multipliers(const ConstraintViolation<S>& components, const StateVector& lambda) {
    using std::abs;
    for (const GraphEdge& edge : plan_.graph.edges) {
      if (edge.is_soft) continue;
      BalanceSize& size = size_[components.component_of(edge.i < mechanism_.nb() ? edge.i : edge.j)];
      for (int k = 0; k < edge.size(); ++k) size.multipliers += abs(lambda[edge.rows[k]]);
    }
  }
  /// Writes Phi_q^T lambda of every body into on_.
  void apply_multipliers(const GraphAssembly<F>& assembly, const StateVector& lambda) {
    std::fill(on_.begin(), on_.end(), BodyPart<S>{});
    for (std::size_t e = 0; e < plan_.graph.edges.size(); ++e) {
      const GraphEdge& edge = plan_.graph.edges[e];
      if (edge.is_soft || plan_.rows_slot[e] < 0) continue;
      const EdgeRows<S>& rows = assembly.matrix().rows[plan_.rows_slot[e]];
      for (int k = 0; k < edge.size(); ++k) {
        const S& multiplier = lambda[edge.rows[k]];
        on_[edge.i] += {multiplier * rows.C_i.r.col(k), multiplier * rows.C_i.x.col(k)};
        on_[edge.j] += {multiplier * rows.C_j.r.col(k), multiplier * rows.C_j.x.col(k)};
      }
    }
    for (const auto& link : assembly.links()) {
      const GraphEdge& edge = plan_.graph.edges[link.edge];
      const PointRows<S>& rows = assembly.matrix().point[link.link];
      const EliminationPlan::Link& bodies = plan_.links[link.link];
      Padded<S> f = Padded<S>::Zero();
      for (int k = 0; k < 3; ++k) f[k] = rows.sign * lambda[edge.rows[k]];
      Padded<S> on_child = times<S, 3>(rows.L_child, f), on_parent = -times<S, 3>(rows.L_parent, f);
      for (int k = 3; k < edge.size(); ++k) {
        on_child += lambda[edge.rows[k]] * rows.W_child.col(k - 3);
        on_parent += lambda[edge.rows[k]] * rows.W_parent.col(k - 3);
      }
      on_[bodies.body] += {f, on_child};
      on_[bodies.parent] += {Padded<S>(-f), on_parent};
    }
  }

  /// Largest values over the bodies of a component: sum of the acting magnitudes, and residual.
  struct BalanceSize {
    S force{0}, moment{0}, force_left{0}, moment_left{0};
    S multipliers{0};  ///< sum of their magnitudes, where constraint forces cancel [N]
  };

  const MechanismOf<F>& mechanism_;
  const EliminationPlan& plan_;
  std::vector<BodyPart<S>> on_;  ///< per body: its part of Phi_q^T lambda
  std::vector<BalanceSize> size_;
};

}  // namespace trivium
