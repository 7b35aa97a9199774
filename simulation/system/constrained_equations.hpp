#pragma once
/// The equations of motion of one formulation with their constraints, for implicit methods:
///
///   M(q) v' + Phi_q^T lambda = Q(q, v, t),   Phi(q, t) = 0
///
/// in the same flat numbers y = (q, v, work) as the first-order form. Residuals are in the reduced unknowns
/// (three of rotation a body: r-p's internal row is met by `normalise_step`), and so is Newton's matrix
///
///   [ M + gamma' C + beta' K   Phi_q^T ] [ dv'     ]     [ M v' + Phi_q^T lambda - Q ]
///   [ Phi_q                    0       ] [ dlambda ] = - [ Phi / beta'               ]
///
/// where beta' and gamma' say how far q and v move with v'. With its rows scaled so, its condition does not
/// grow as the steps get small. K and C are those of springs and dampers along their own directions, each a
/// soft row with its compliance 1 / (gamma' c + beta' k); what gyroscopic and geometric terms would add is
/// left to the iteration, which falls by about the angle that bodies turn in a step.
///
/// Models integrators' ConstrainedSystem.

#include <array>
#include <deque>
#include <limits>
#include <vector>

#include "simulation/system/first_order_equations.hpp"

namespace trivium {

namespace detail {

/// Calls visit(effect) for every spring or damper that resists.
template <class S, class Visit>
void for_each_resisting_spring(const Effects<S>& effects, const Visit& visit) {
  effects.for_each_spring([&](const auto& spring) {
    if (spring.stiffness != S(0) || spring.damping != S(0)) visit(spring);
  });
}

/// The mechanism's graph, with a soft edge for each of them.
template <class S>
BodyJointGraph graph_with_springs(const Mechanism<S>& mechanism) {
  BodyJointGraph graph = body_joint_graph(mechanism);
  for_each_resisting_spring(mechanism.effects, [&](const auto& spring) {
    graph.edges.push_back({{spring.i, spring.j}, {-1}, false, true, true});
  });
  return graph;
}

}  // namespace detail

template <Formulation F>
class ConstrainedEquations : public FirstOrderEquations<F> {
  using Base = FirstOrderEquations<F>;
  using Base::mechanism_, Base::state_, Base::motion_, Base::solver_;

 public:
  using S = typename F::Scalar;
  using StateVector = VectorX<S>;
  using Base::nb;

  ConstrainedEquations(const Mechanism<S>& mechanism, const MechanismState<S>& start,
                       const FirstOrderOptions& options = {})
      : Base(mechanism, start, options),
        plan_(plan_elimination(detail::graph_with_springs(mechanism_))),
        measure_(mechanism_, plan_.graph, start.t),
        right_side_(plan_.graph),
        rows_(right_side_),
        given_(right_side_),
        change_(right_side_),
        on_(nb() + 1),
        wrenches_(nb() + 1),
        size_(nb() + 1),
        spring_size_(nb() + 1) {
    select(0);
    const auto& edges = plan_.graph.edges;
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (edges[e].is_soft) soft_.push_back(static_cast<int>(e));
  }

  // y = (q, v, work): how many numbers q and v have, and lambda
  int position_size() const { return Base::positions * nb(); }
  int velocity_size() const { return Base::velocities * nb(); }
  int multipliers() const { return mechanism_.nc(); }

  /// v' and lambda of index 1. Throws a ModelError.
  void accelerations(const S& t, const StateVector& y, StateVector& v_dot, StateVector& lambda) {
    const AccelerationSolver<F>& solved = this->solved(t, y);
    v_dot.resize(velocity_size());
    for (int b = 0; b < nb(); ++b) of(v_dot, b) << solved.r_ddot(b), solved.q_ddot(b);
    lambda.resize(multipliers());
    solved.copy_lambda(lambda);
  }

  /// y's positions, step from those of `from` as far as by velocities in one unit of time.
  void displace(const StateVector& from, const StateVector& displacement, StateVector& y) const {
    for (int b = 0; b < nb(); ++b)
      this->place(y, b) << from.template segment<3>(Base::positions * b) + r_of(displacement, b),
          F::step(state_[b].chart, this->flat(from, b), q_of(displacement, b));
  }
  /// The displacement from one to another.
  void displacement(const StateVector& from, const StateVector& to, StateVector& displacement) const {
    displacement.resize(velocity_size());
    for (int b = 0; b < nb(); ++b)
      of(displacement, b) << to.template segment<3>(Base::positions * b) -
                                 from.template segment<3>(Base::positions * b),
          F::displacement(state_[b].chart, this->flat(from, b), this->flat(to, b));
  }
  /// How a displacement from a fixed place grows where the bodies move with v.
  void displacement_rate(const StateVector& displacement, const StateVector& v, StateVector& rate) const {
    rate.resize(velocity_size());
    for (int b = 0; b < nb(); ++b)
      of(rate, b) << r_of(v, b), F::displacement_rate(q_of(displacement, b), q_of(v, b));
  }
  /// How the numbers of y's positions grow where the bodies move with v.
  void position_rate(const StateVector& y, const StateVector& v, StateVector& rate) const {
    rate.resize(position_size());
    for (int b = 0; b < nb(); ++b)
      this->place(rate, b) << r_of(v, b), F::orientation_rate(state_[b].chart, this->flat(y, b), q_of(v, b));
  }
  /// By displacements' numbers: a body's distance from the origin [m], and 1 for what turns it.
  void position_sizes(const StateVector& y, StateVector& sizes) const {
    sizes.setOnes(velocity_size());
    for (int b = 0; b < nb(); ++b)
      of(sizes, b).template head<3>().setConstant(y.template segment<3>(Base::positions * b).norm());
  }
  /// Adds to v' what moves y, by `share` of it, onto the internal rows, and moves y's positions there.
  /// Returns whether there are any such rows.
  bool normalise_step(const S& share, StateVector& y, StateVector& v_dot) const {
    if constexpr (F::internal_constraints == 0) {
      return false;
    } else {
      for (int b = 0; b < nb(); ++b) {
        typename F::Orientation x = this->flat(y, b);
        typename F::Unknown change = q_of(v_dot, b);
        F::normalise_step(x, share, change);
        this->place(y, b).tail(F::orientation_size) = x;
        of(v_dot, b).tail(F::rotational_unknowns) = change;
      }
      return true;
    }
  }

  /// The same for their derivatives: adds to v' what moves v, by `share` of it.
  void normalise_step_velocity(const S& share, const StateVector& y, StateVector& v_dot) const {
    if constexpr (F::internal_constraints > 0)
      for (int b = 0; b < nb(); ++b) {
        typename F::Unknown change = q_of(v_dot, b);
        F::normalise_step_velocity(this->flat(y, b), this->velocity_of(y, b), share, change);
        of(v_dot, b).tail(F::rotational_unknowns) = change;
      }
  }

  /// Whether M does not depend on q.
  bool inertia_is_constant() const { return F::inertia_is_constant; }
  /// M(q) v' at y.
  void inertia_force(const StateVector& y, const StateVector& v_dot, StateVector& force) {
    if constexpr (!F::inertia_is_constant) this->load(y);
    force.resize(velocity_size());
    for (int b = 0; b < nb(); ++b) {
      const RigidBody<S>& of_body = mechanism_.bodies[b];
      of(force, b) << of_body.mass * r_of(v_dot, b),
          F::mass_block(kinematics(b), of_body.inertia) * q_of(v_dot, b);
    }
  }
  /// What effects do at y.
  void applied_force(const S& t, const StateVector& y, StateVector& force) {
    this->load(y);
    move(t);
    apply_effects();
    force.resize(velocity_size());
    for (int b = 0; b < nb(); ++b)
      of(force, b) << wrenches_[b].F, F::applied_force(selected_->evaluated().body()[b], wrenches_[b].n_bar);
  }
  /// Evaluations and matrices can be kept side by side, as those of several stages: all that follows is about
  /// the one of this number, until the next is selected.
  void select(int number) {
    while (static_cast<int>(kept_.size()) <= number) kept_.emplace_back(mechanism_, plan_);
    selected_ = &kept_[number];
  }
  /// Evaluates force + Phi_q^T lambda - Q, Phi and Phi_q at y, from where `newton` and `factor` take them;
  /// `force` is what stands in the place of M v'. Returns the largest imbalance of a body, as a share of the
  /// forces or moments on the bodies that it is connected with.
  S residual(const S& t, const StateVector& y, const StateVector& force, const StateVector& lambda) {
    this->load(y);
    move(t);
    apply_effects();
    GraphAssembly<F>& assembly = selected_->evaluated();
    place_springs(assembly);
    for (const auto& link : assembly.links()) assembly.assemble_link(link, t, change_);
    assembly.assemble_closings(t, change_);
    measure_positions();
    return measure_balance(assembly, force, lambda);
  }
  /// Phi at y alone, or Phi' where bodies were moved last, in the place of Phi; how large it is beside the
  /// lengths or speeds of what moves together.
  S position_rows(const S& t, const StateVector& y) {
    this->load(y);
    move(t);
    return measure_positions();
  }
  S velocity_rows() {
    rows_.edge = right_side_.edge;
    selected_->evaluated().velocities(t_, right_side_);
    measure_.measure_velocities(right_side_);
    return measure_.relative();
  }
  /// The largest |Phi_k| (or |Phi_k'|) of what was evaluated last, beside the lengths (or speeds) of what
  /// moves together; and of which row.
  const S& relative_row_violation() const { return measure_.relative(); }
  const std::string& least_met_row() const { return measure_.worst_row(); }
  /// Newton's matrix of what was balanced last. Throws a ModelError.
  void factor(const S& velocity_share, const S& position_share) {
    GraphAssembly<F>& assembly = selected_->evaluated();
    let_springs_resist(assembly, velocity_share, position_share);
    selected_->solver.keep_dependent_rows_of(solver_.factors());
    ++newton_matrices_;
    try {
      selected_->solver.factor(assembly.matrix());
    } catch (const SingularLink& link) {
      throw solver_.named(link, t_);
    }
    selected_->in_factors = selected_->in_use;
  }
  /// What removes the imbalance and the rows' violation evaluated last, by the factors at hand: added to v'
  /// and lambda, where v' moves what the rows measure by `share`.
  void newton(const S& share, StateVector& v_dot, StateVector& lambda) {
    for (Vector6<S>& row : right_side_.edge) row /= -share;
    solve(right_side_, v_dot, &lambda);
  }
  /// M x + Phi_q^T mu = 0, Phi_q x = -Phi + share Phi' of what was evaluated last, velocity rows after
  /// positions: added to x. Where v' meets the velocity rows, it moves Phi by that share of them.
  void project(const S& share, StateVector& x) {
    for (std::size_t e = 0; e < rows_.edge.size(); ++e)
      rows_.edge[e] = share * right_side_.edge[e] - rows_.edge[e];
    solve(rows_, x, nullptr);
  }
  /// What was evaluated last, to solve for with others of its kind: the rows by number, and what the bodies'
  /// forces leave (reduced, in the places of velocities).
  void row_residual(StateVector& rows) const {
    rows.resize(multipliers());
    for_each_row([&](std::size_t e, int k, int row) { rows[row] = right_side_.edge[e][k]; });
  }
  void force_residual(StateVector& left) const {
    left.setZero(velocity_size());
    for (int b = 0; b < nb(); ++b) of(left, b).template head<6>() = right_side_.body[b].six();
  }
  /// The same of a generalised force, where the matrix is.
  void take_force(const StateVector& force, StateVector& left) const {
    left.setZero(velocity_size());
    for (int b = 0; b < nb(); ++b)
      of(left, b).template head<6>() << r_of(force, b),
          F::reduced(selected_->factored().body()[b], q_of(force, b));
  }
  /// M x + Phi_q^T mu = left, Phi_q x = rows: added to x and mu.
  void solve(const StateVector& left, const StateVector& rows, StateVector& x, StateVector& mu) {
    give(left, rows);
    solve(given_, x, &mu);
  }
  /// The same where springs resist only what x stretches them by beyond a slack; and by how much it does
  /// stretch them.
  void solve(const StateVector& left, const StateVector& rows, const StateVector& slack, StateVector& x,
             StateVector& mu, StateVector& stretch) {
    give(left, rows);
    for (std::size_t s = 0; s < soft_.size(); ++s) given_.edge[soft_[s]][0] = slack[s];
    solve_with_slack(given_, x, &mu);
    stretch.resize(slack.size());
    for (std::size_t s = 0; s < soft_.size(); ++s) {
      const int slot = plan_.rows_slot[soft_[s]];
      stretch[s] =
          slack[s] + selected_->factored().matrix().rows[slot].compliance * change_.edge[soft_[s]][0];
    }
  }
  /// The same for a generalised force, and rows that ask nothing.
  void solve_force(const StateVector& force, StateVector& x, StateVector& mu) {
    put_force(force, given_);
    for (Vector6<S>& rows : given_.edge) rows.setZero();
    solve(given_, x, &mu);
  }
  bool has_springs() const { return !soft_.empty(); }
  /// [N/m, N s/m], or of moments by angles [N m, N m s].
  void spring_constants(StateVector& stiffness, StateVector& damping) const {
    stiffness.resize(soft_.size());
    damping.resize(soft_.size());
    int s = 0;
    detail::for_each_resisting_spring(mechanism_.effects, [&](const auto& spring) {
      stiffness[s] = spring.stiffness;
      damping[s++] = spring.damping;
    });
  }
  /// What v' leaves of the internal rows' second derivatives where bodies were loaded last, in the places of
  /// velocities that force_residual leaves at 0.
  void take_internal_rows(const StateVector& v_dot, StateVector& left) const {
    if constexpr (F::internal_constraints > 0)
      for (int b = 0; b < nb(); ++b) {
        const auto body = kinematics(b);
        of(left, b).template tail<F::internal_constraints>() =
            F::internal_gamma(body) - F::internal_jacobian(body) * q_of(v_dot, b);
      }
  }
  /// Adds to x what removes that, by the least change of the unknowns.
  void solve_internal_rows(const StateVector& y, const StateVector& left, StateVector& x) {
    if constexpr (F::internal_constraints > 0) {
      this->load(y);
      for (int b = 0; b < nb(); ++b) {
        const auto P = F::internal_jacobian(kinematics(b));
        const auto rows = left.template segment<F::internal_constraints>(Base::velocities * b + 6);
        of(x, b).template tail<F::rotational_unknowns>() +=
            P.transpose() * rows.cwiseQuotient(P.rowwise().squaredNorm());
      }
    }
  }
  /// M x + Phi_q^T mu = force, Phi_q x = - the rows evaluated last: added to x and mu.
  void velocity_projection(const StateVector& force, StateVector& x, StateVector& mu) {
    put_force(force, right_side_);
    newton(S(1), x, mu);
  }
  /// The rate of the work [W] where it was evaluated last.
  S work_rate(const StateVector& lambda) { return this->power(selected_->evaluated().body(), lambda, t_); }

  long factorisations() const { return Base::factorisations() + newton_matrices_; }
  /// Newton's alone, each made anew.
  long newton_matrices() const { return newton_matrices_; }

 private:
  static auto of(StateVector& v, int b) { return v.template segment<Base::velocities>(Base::velocities * b); }
  static Vector3<S> r_of(const StateVector& v, int b) { return v.template segment<3>(Base::velocities * b); }
  static typename F::Unknown q_of(const StateVector& v, int b) {
    return v.template segment<F::rotational_unknowns>(Base::velocities * b + 3);
  }

  /// To the state that is loaded.
  void move(const S& t) {
    selected_->in_use = 1 - selected_->in_factors;
    t_ = t;
    for (int b = 0; b < nb(); ++b) selected_->evaluated().move_body(b, state_[b]);
    measure_.move(selected_->evaluated().body());
  }
  void apply_effects() {
    const auto& body = selected_->evaluated().body();
    std::copy(body.begin(), body.end(), motion_.begin());
    for (Wrench<S>& w : wrenches_) w = {};
    mechanism_.effects.apply(this->view(t_), wrenches_);
  }
  S measure_positions() {
    selected_->evaluated().positions(t_, right_side_);
    measure_.measure_positions(right_side_);
    return measure_.relative();
  }
  typename F::Kinematics kinematics(int b) const {
    const BodyState<F>& body = state_[b];
    return F::kinematics(body.chart, body.r, body.r_dot, body.q);
  }
  void give(const StateVector& left, const StateVector& rows) {
    for (int b = 0; b < nb(); ++b)
      given_.body[b] = BodyPart<S>::of(left.template segment<6>(Base::velocities * b));
    for_each_row([&](std::size_t e, int k, int row) { given_.edge[e][k] = rows[row]; });
  }
  void solve(GraphVector<S>& right_side, StateVector& x, StateVector* lambda) {
    for (const int e : soft_) right_side.edge[e].setZero();
    solve_with_slack(right_side, x, lambda);
  }
  void solve_with_slack(GraphVector<S>& right_side, StateVector& x, StateVector* lambda) {
    selected_->solver.solve(right_side, change_);
    for (int b = 0; b < nb(); ++b)
      of(x, b) += (typename Base::Velocity() << unpadded<S>(change_.body[b].r),
                   F::increment(selected_->evaluated().body()[b], unpadded<S>(change_.body[b].x)))
                      .finished();
    if (lambda != nullptr)
      for_each_row([&](std::size_t e, int k, int row) { (*lambda)[row] += change_.edge[e][k]; });
  }
  void put_force(const StateVector& force, GraphVector<S>& right_side) const {
    for (int b = 0; b < nb(); ++b)
      right_side.body[b] = {padded<S>(r_of(force, b)),
                            padded<S>(F::reduced(selected_->factored().body()[b], q_of(force, b)))};
  }
  /// Calls visit(edge, k, row) for the mechanism's rows.
  template <class Visit>
  void for_each_row(const Visit& visit) const {
    const auto& edges = plan_.graph.edges;
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (!edges[e].is_soft)
        for (int k = 0; k < edges[e].size(); ++k) visit(e, k, edges[e].rows[k]);
  }

  /// What the multipliers do to the bodies, into on_.
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

  S measure_balance(const GraphAssembly<F>& assembly, const StateVector& force, const StateVector& lambda) {
    apply_multipliers(assembly, lambda);
    for (BalanceSize& size : size_) size = {};
    const S u = std::numeric_limits<S>::epsilon();
    S all_left(0);
    for (int b = 0; b < nb(); ++b) {
      const typename F::Reduced& body = assembly.body()[b];
      const Vector3<S> inertia = F::reduced(body, q_of(force, b));
      const Vector3<S> applied = F::reduced(body, F::applied_force(body, wrenches_[b].n_bar) +
                                                      F::velocity_force(body, mechanism_.bodies[b].inertia));
      const Vector3<S> held_r = unpadded<S>(on_[b].r), held_x = unpadded<S>(on_[b].x);
      const Vector3<S> left_r = wrenches_[b].F - r_of(force, b) - held_r, left_x = applied - inertia - held_x;
      right_side_.body[b] = {padded<S>(left_r), padded<S>(left_x)};
      const auto norm = [&](const Vector3<S>& x) { return F::moment(body, x).norm(); };
      BalanceSize& size = size_[measure_.component_of(b)];
      size.force = larger(size.force, S(wrenches_[b].F.norm() + r_of(force, b).norm() + held_r.norm()));
      size.moment = larger(size.moment, S(norm(applied) + norm(inertia) + norm(held_x)));
      all_left += left_r.squaredNorm() + left_x.squaredNorm();
      // springs that hold each other may leave no force that their own rounding could be measured by
      size.force_left = larger(size.force_left, S(left_r.norm() - u * spring_size_[b].force));
      size.moment_left = larger(size.moment_left, S(norm(left_x) - u * spring_size_[b].moment));
    }
    // comparisons pass over what is no number
    if (!(all_left <= std::numeric_limits<S>::max())) return std::numeric_limits<S>::max();
    S largest(0);
    for (int b = 0; b < nb(); ++b) {
      const BalanceSize& size = size_[measure_.component_of(b)];
      const auto raise = [&](const S& left, const S& whole) {
        if (left > largest * whole) largest = left / whole;
      };
      raise(size.force_left, size.force);
      // arms are differences of places
      raise(S(size.moment_left - u * measure_.length_of(b) * size.force),
            S(size.moment + measure_.arm_of(b) * size.force));
    }
    return largest;
  }

  /// What springs and dampers do along themselves.
  void place_springs(GraphAssembly<F>& assembly) {
    if (soft_.empty()) return;
    std::fill(spring_size_.begin(), spring_size_.end(), SpringSize{});
    auto edge = soft_.begin();
    detail::for_each_resisting_spring(mechanism_.effects, [&](const auto& spring) {
      EdgeRows<S>& rows = assembly.edge_rows(plan_.rows_slot[*edge++]);
      const auto gradient = spring.gradient(this->view(t_));
      const auto put = [&](BodyColumns<S>& column, int b, const Wrench<S>& on) {
        const typename F::Reduced& body = assembly.body()[b];
        column.r.col(0) = padded<S>(on.F);
        column.x.col(0) = padded<S>(F::reduced(body, F::applied_force(body, on.n_bar)));
      };
      put(rows.C_i, spring.i, gradient.first);
      put(rows.C_j, spring.j, gradient.second);
      const S size = made_of(spring);
      for (const auto& [b, on] : {std::pair(spring.i, &gradient.first), {spring.j, &gradient.second}}) {
        spring_size_[b].force += size * on->F.norm();
        spring_size_[b].moment += size * on->n_bar.norm();
      }
    });
  }
  /// The size of the numbers [N, N m] that a spring's tension is the difference of.
  template <class Spring>
  S made_of(const Spring& spring) const {
    const auto &i = motion_[spring.i], &j = motion_[spring.j];
    if constexpr (requires { spring.s_bar_i; }) {
      const S s_i = spring.s_bar_i.norm(), s_j = spring.s_bar_j.norm();
      return spring.stiffness * (i.r.norm() + s_i + j.r.norm() + s_j + spring.free_length) +
             spring.damping *
                 (i.r_dot.norm() + i.omega_bar.norm() * s_i + j.r_dot.norm() + j.omega_bar.norm() * s_j);
    } else {
      return spring.stiffness * S(10) + spring.damping * (i.omega_bar.norm() + j.omega_bar.norm());
    }
  }
  void let_springs_resist(GraphAssembly<F>& assembly, const S& velocity_share, const S& position_share) {
    auto edge = soft_.begin();
    detail::for_each_resisting_spring(mechanism_.effects, [&](const auto& spring) {
      EdgeRows<S>& rows = assembly.edge_rows(plan_.rows_slot[*edge++]);
      const S resistance = velocity_share * spring.damping + position_share * spring.stiffness;
      if (resistance == S(0)) rows = {};  // an explicit method's
      rows.compliance = resistance == S(0) ? S(1) : S(1 / resistance);
    });
  }

  /// Newton's matrix in factors, beside what was evaluated last: the factors go on using their own rows.
  struct Kept {
    GraphSolver<S> solver;
    std::array<GraphAssembly<F>, 2> at;
    int in_use = 0, in_factors = 1;

    Kept(const Mechanism<S>& mechanism, const EliminationPlan& plan)
        : solver(plan), at{GraphAssembly<F>(mechanism, plan), GraphAssembly<F>(mechanism, plan)} {}
    GraphAssembly<F>& evaluated() { return at[in_use]; }
    const GraphAssembly<F>& factored() const { return at[in_factors]; }
  };

  const EliminationPlan plan_;
  std::deque<Kept> kept_;
  Kept* selected_ = nullptr;
  ConstraintViolation<S> measure_;
  GraphVector<S> right_side_, rows_, given_, change_;  ///< the bodies of rows_ stay 0
  std::vector<BodyPart<S>> on_;
  std::vector<Wrench<S>> wrenches_;
  /// Of an assembly, the largest of a body: all that acts on it, and what does not balance.
  struct BalanceSize {
    S force{0}, moment{0}, force_left{0}, moment_left{0};
  };
  std::vector<BalanceSize> size_;
  /// By body: of the numbers whose differences springs pull and turn it by.
  struct SpringSize {
    S force{0}, moment{0};
  };
  std::vector<SpringSize> spring_size_;
  std::vector<int> soft_;  ///< edges of springs, in the effects' order
  S t_{0};
  long newton_matrices_ = 0;
};

}  // namespace trivium
