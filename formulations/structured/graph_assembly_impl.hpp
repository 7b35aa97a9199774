#pragma once
/// The definition of GraphAssembly, for its instances. A part of acceleration_solver_impl.hpp.

#include <variant>

#include "formulations/structured/graph_assembly.hpp"

namespace trivium {

template <Formulation F>
GraphAssembly<F>::GraphAssembly(const MechanismOf<F>& mechanism, const EliminationPlan& plan)
    : mechanism_(mechanism), plan_(plan), matrix_(plan) {
  // the last body is the ground, which never moves
  body_.resize(mechanism.nb() + 1);
  body_.back() = Body{body_kinematics(std::vector<BodyState<F>>{}).back()};
  angular_motion_.resize(mechanism.nb() + 1);
  angular_motion_.back() = F::angular_motion(body_.back());
  for (int b = 0; b < mechanism.nb(); ++b) {
    matrix_.H[b].rr.diagonal().setConstant(mechanism.bodies[b].mass);
    if constexpr (F::reduced_mass_is_constant) set_mass_block(b);
  }
  for (std::size_t n = 0; n < plan.links.size(); ++n) {
    const EliminationPlan::Link& link = plan.links[n];
    if (plan.is_point_link(link))
      links_.push_back(
          {static_cast<int>(n), link.edge, link.body_is_j, {mechanism, plan.graph.edges[link.edge]}});
  }
  for (int e = 0; e < static_cast<int>(plan.graph.edges.size()); ++e) {
    const GraphEdge& edge = plan.graph.edges[e];
    if (plan.rows_slot[e] < 0 || edge.is_soft) continue;
    if (edge.is_point) {
      closings_.push_back({e, {mechanism, edge}});
      // the constant part of the three rows r_j'' + L_j^T x_j - r_i'' - L_i^T x_i = gamma
      EdgeRows<S>& rows = matrix_.rows[plan.rows_slot[e]];
      for (int k = 0; k < 3; ++k) {
        rows.C_i.r(k, k) = S(-1);
        rows.C_j.r(k, k) = S(1);
      }
    } else {
      others_.push_back(e);
    }
  }
}

template <Formulation F>
[[gnu::flatten]] void GraphAssembly<F>::move_body(int b, const BodyState<F>& state) {
  body_[b] = Body{kinematics_of(state)};
  angular_motion_[b] = F::angular_motion(body_[b]);
  if constexpr (!F::reduced_mass_is_constant) set_mass_block(b);
}

template <Formulation F>
void GraphAssembly<F>::assemble_link(const LinkJoint& link, const S& t, GraphVector<S>& right_side) {
  PointRows<S>& rows = matrix_.point[link.link];
  Vector6<S>& gamma = right_side.edge[link.edge];
  if (link.child_is_j)
    link.joint.evaluate(angular_motion_, body_, t, rows.L_parent, rows.L_child, rows.W_parent, rows.W_child,
                        gamma);
  else
    link.joint.evaluate(angular_motion_, body_, t, rows.L_child, rows.L_parent, rows.W_child, rows.W_parent,
                        gamma);
}

template <Formulation F>
void GraphAssembly<F>::assemble_closings(const S& t, GraphVector<S>& right_side) {
  for (const ClosingJoint& closing : closings_) assemble_closing(closing, t, right_side);
  for (const int edge : others_) assemble_rows(edge, t, right_side);
}

template <Formulation F>
void GraphAssembly<F>::positions(const S& t, GraphVector<S>& phi) const {
  for (const LinkJoint& link : links_) link.joint.positions(body_, t, phi.edge[link.edge]);
  for (const ClosingJoint& closing : closings_) closing.joint.positions(body_, t, phi.edge[closing.edge]);
  for (const int e : others_)
    rows_of(
        e, [](const auto&... of) { return row_position(of...); }, t, phi);
}

template <Formulation F>
void GraphAssembly<F>::velocities(const S& t, GraphVector<S>& phi_dot) const {
  for (const LinkJoint& link : links_)
    link.joint.velocities(angular_motion_, body_, t, phi_dot.edge[link.edge]);
  for (const ClosingJoint& closing : closings_)
    closing.joint.velocities(angular_motion_, body_, t, phi_dot.edge[closing.edge]);
  for (const int e : others_)
    rows_of(
        e, [](const auto&... of) { return row_velocity(of...); }, t, phi_dot);
}

template <Formulation F>
template <class Mark>
void GraphAssembly<F>::find_vanishing_rows(const S& share, const Mark& mark) const {
  for (const int e : others_) {
    const GraphEdge& edge = plan_.graph.edges[e];
    for (int k = 0; k < edge.size(); ++k)
      std::visit(
          [&](const auto& row) {
            if constexpr (requires { row.vanishes(body_[row.i], body_[row.j], share); })
              if (row.vanishes(body_[row.i], body_[row.j], share)) mark(e, k);
          },
          mechanism_.rows[edge.rows[k]]);
  }
}

template <Formulation F>
void GraphAssembly<F>::set_mass_block(int b) {
  matrix_.H[b].xx = padded_columns<S>(F::reduced_mass_block(body_[b], mechanism_.bodies[b].inertia));
}

template <Formulation F>
void GraphAssembly<F>::assemble_closing(const ClosingJoint& closing, const S& t, GraphVector<S>& right_side) {
  EdgeRows<S>& rows = matrix_.rows[plan_.rows_slot[closing.edge]];
  closing.joint.evaluate(angular_motion_, body_, t, rows.C_i.x.template leftCols<3>(),
                         rows.C_j.x.template leftCols<3>(), rows.C_i.x.template rightCols<3>(),
                         rows.C_j.x.template rightCols<3>(), right_side.edge[closing.edge]);
  // evaluate() writes +L_i, but the rows contain -L_i^T x_i
  rows.C_i.x.template leftCols<3>() *= S(-1);
}

template <Formulation F>
void GraphAssembly<F>::assemble_rows(int e, const S& t, GraphVector<S>& right_side) {
  const GraphEdge& edge = plan_.graph.edges[e];
  EdgeRows<S>& rows = matrix_.rows[plan_.rows_slot[e]];
  for (int k = 0; k < edge.size(); ++k) {
    const auto& constraint = mechanism_.rows[edge.rows[k]];
    const BodyPair pair = bodies_of(constraint);
    const auto row = evaluate_row(constraint, body_[pair.i], body_[pair.j], t);
    const auto place = [&](BodyColumns<S>& C, const auto& r, const auto& x) {
      C.r.col(k) = padded<S>(r.transpose());
      C.x.col(k) = padded<S>(x.transpose());
    };
    // a row may name the two bodies of its edge in the opposite order
    place(pair.i == edge.i ? rows.C_i : rows.C_j, row.r_i, row.rot_i);
    place(pair.i == edge.i ? rows.C_j : rows.C_i, row.r_j, row.rot_j);
    right_side.edge[e][k] = row.gamma;
  }
}

template <Formulation F>
template <class Of>
void GraphAssembly<F>::rows_of(int e, const Of& of, const S& t, GraphVector<S>& values) const {
  const GraphEdge& edge = plan_.graph.edges[e];
  for (int k = 0; k < edge.size(); ++k) {
    const auto& constraint = mechanism_.rows[edge.rows[k]];
    const BodyPair pair = bodies_of(constraint);
    values.edge[e][k] = of(constraint, body_[pair.i], body_[pair.j], t);
  }
}

}  // namespace trivium
