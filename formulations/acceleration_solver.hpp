#pragma once
/// Accelerations and multipliers of one formulation in O(nb): the augmented system with its normalisation
/// rows eliminated in closed form, assembled joint by joint and solved along the body-joint graph. One object
/// per mechanism, planned once; solving again at another state allocates nothing.

#include <cmath>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "formulations/equations_of_motion.hpp"
#include "formulations/graph_solver.hpp"

namespace trivium {

/// What one refinement corrected, relative: accelerations in the mass metric; multipliers by the forces and
/// by the moments that they exert, whichever is worse. It is the error of the unrefined solution; what is
/// left is smaller.
struct Corrections {
  double acceleration = 0, lambda = 0;
};

enum class Refinement { none, once };

template <Formulation F>
class AccelerationSolver {
 public:
  using S = typename F::Scalar;
  using Body = typename F::Reduced;

  /// The mechanism must outlive the solver.
  explicit AccelerationSolver(const Mechanism<S>& mechanism)
      : mechanism_(mechanism),
        solver_(plan_elimination(body_joint_graph(mechanism))),
        matrix_(solver_.plan()),
        right_side_(solver_.plan().graph),
        solution_(right_side_),
        defect_(right_side_),
        step_(right_side_),
        wrenches_(mechanism.nb() + 1),
        motion_(mechanism.nb() + 1) {
    body_.resize(mechanism.nb() + 1);
    body_.back() = Body{body_kinematics(std::vector<BodyState<F>>{}).back()};
    for (int b = 0; b < mechanism.nb(); ++b) {
      matrix_.H[b].rr = mechanism.bodies[b].mass * Matrix3<S>::Identity();
      matrix_.H[b].rx.setZero();
    }
    plan_assembly();
  }

  /// Solves at a state. Throws a ModelError that names the body where a link is singular.
  void solve(std::span<const BodyState<F>> state, const S& t, Refinement refinement = Refinement::once) {
    assemble(state, t);
    factor();
    solver_.solve(right_side_, solution_);
    if (refinement == Refinement::once) refine();
  }

  // the steps of `solve`, for those who time or reuse them
  void assemble(std::span<const BodyState<F>> state, const S& t) {
    for (int b = 0; b < mechanism_.nb(); ++b)
      body_[b] = Body{F::kinematics(state[b].chart, state[b].r, state[b].r_dot, state[b].q)};
    apply_effects(t);
    for (int b = 0; b < mechanism_.nb(); ++b) {
      const Matrix3<S>& J_bar = mechanism_.bodies[b].inertia;
      matrix_.H[b].xx = F::reduced_mass_block(body_[b], J_bar);
      right_side_.body[b].template head<3>() = wrenches_[b].F;
      right_side_.body[b].template tail<3>() = F::reduced_force(body_[b], J_bar, wrenches_[b].n_bar);
    }
    for (const PointJoint& joint : points_) assemble_point(joint, t);
    for (const int edge : general_) assemble_rows(edge, t);
  }
  void factor() {
    try {
      solver_.factor(matrix_);
    } catch (const SingularLink& e) {
      throw ModelError(fmt::format(
          "body \"{}\": {}; its links cannot be eliminated one by one: solve the printed system instead",
          mechanism_.body_names[e.body()], e.what()));
    }
  }
  /// One step of iterative refinement.
  void refine() {
    solver_.residual(matrix_, right_side_, solution_, defect_);
    solver_.solve(defect_, step_);
    measure_and_add_step();
  }

  const EliminationPlan& plan() const { return solver_.plan(); }
  /// Of the last refinement.
  const Corrections& corrections() const { return corrections_; }

  Vector3<S> r_ddot(int b) const { return solution_.body[b].template head<3>(); }
  /// The formulation's own unknown.
  typename F::Unknown q_ddot(int b) const {
    return F::from_reduced(body_[b], Vector3<S>(solution_.body[b].template tail<3>()));
  }
  Vector3<S> omega_bar_dot(int b) const { return F::to_angular_acceleration(body_[b], q_ddot(b)); }
  /// One multiplier per row of the mechanism; 0 in rows that were left out because they depend on others.
  VectorX<S> lambda() const {
    VectorX<S> all(mechanism_.nc());
    for_each_row([&](int edge, int k, int row) { all[row] = solution_.edge[edge][k]; });
    return all;
  }
  std::vector<int> dropped_rows() const {
    std::vector<int> rows;
    for_each_row([&](int edge, int k, int row) {
      if (solver_.is_dropped(edge, k)) rows.push_back(row);
    });
    std::sort(rows.begin(), rows.end());
    return rows;
  }
  int rank() const { return mechanism_.nc() - static_cast<int>(dropped_rows().size()); }

  /// Which multipliers are unique: those that no combination that acts on nothing contains. One solve per
  /// dropped row; not for the timed path.
  std::vector<bool> unique();

 private:
  /// The rows of a point joint in the tree, its body vectors listed once.
  struct PointJoint {
    int link, edge;
    BodyPair bodies;
    bool child_is_j;
    Vector3<S> s_bar_i, s_bar_j;
    /// At most three vectors, each once.
    struct Vectors {
      std::array<Vector3<S>, 3> a_bar;
      int size = 0;

      int index_of(const Vector3<S>& vector) {
        int k = 0;
        while (k < size && a_bar[k] != vector) ++k;
        if (k == size) a_bar[size++] = vector;
        return k;
      }
    };
    Vectors on_i, on_j;
    struct Orientation {
      int i, j;  ///< of on_i and on_j; -1: a row of another kind
      int row;
    };
    std::array<Orientation, 3> rows;
    int size = 0;
  };
  using Row = ConstraintRow<S, 3>;

  void plan_assembly() {
    const EliminationPlan& plan = solver_.plan();
    std::vector<bool> is_point_link(plan.graph.edges.size(), false);
    for (std::size_t n = 0; n < plan.links.size(); ++n) {
      const int e = plan.links[n].edge;
      if (e < 0 || !plan.graph.edges[e].is_point) continue;
      is_point_link[e] = true;
      points_.push_back(point_joint(static_cast<int>(n), e));
    }
    for (std::size_t e = 0; e < plan.graph.edges.size(); ++e)
      if (!is_point_link[e]) general_.push_back(static_cast<int>(e));
  }

  PointJoint point_joint(int link, int e) const {
    const GraphEdge& edge = solver_.plan().graph.edges[e];
    const auto& point = std::get<CD<S>>(mechanism_.rows[edge.rows[0]]);
    PointJoint joint{link, e,  edge, solver_.plan().links[link].body_is_j, point.s_bar_i, point.s_bar_j, {},
                     {},   {}, 0};
    for (std::size_t k = 3; k < edge.rows.size(); ++k) {
      const auto* row = std::get_if<DP1<S>>(&mechanism_.rows[edge.rows[k]]);
      const bool plain = row != nullptr && row->i == edge.i && row->f.is_number();
      joint.rows[joint.size++] = {plain ? joint.on_i.index_of(row->a_bar_i) : -1,
                                  plain ? joint.on_j.index_of(row->a_bar_j) : -1, edge.rows[k]};
    }
    return joint;
  }

  void apply_effects(const S& t) {
    for (Wrench<S>& w : wrenches_) w = {};
    if (mechanism_.effects.see_motion()) std::copy(body_.begin(), body_.end(), motion_.begin());
    mechanism_.effects.apply(EffectView<S>{mechanism_.bodies, motion_, t}, wrenches_);
  }

  void assemble_point(const PointJoint& joint, const S& t) {
    const Body &i = body_[joint.bodies.i], &j = body_[joint.bodies.j];
    PointRows<S>& rows = matrix_.point[joint.link];
    Vector6<S>& gamma = right_side_.edge[joint.edge];
    const BodyVector<S> s_i = i.vector(joint.s_bar_i), s_j = j.vector(joint.s_bar_j);
    (joint.child_is_j ? rows.K_child : rows.K_parent) = j.jacobian(s_j);
    (joint.child_is_j ? rows.K_parent : rows.K_child) = i.jacobian(s_i);
    gamma.template head<3>() = s_i.bias - s_j.bias;
    Matrix3<S>&W_i = joint.child_is_j ? rows.W_parent : rows.W_child,
    &W_j = joint.child_is_j ? rows.W_child : rows.W_parent;
    using VectorI = BodyVectorFeature<Body, End::i>;
    using VectorJ = BodyVectorFeature<Body, End::j>;
    const auto place = [&](int k, const Row& row) {
      W_i.col(k) = row.rot_i.transpose();
      W_j.col(k) = row.rot_j.transpose();
      gamma[3 + k] = row.gamma;
    };
    // a vector that two rows share is evaluated once
    for (int n = 0; n < joint.on_j.size; ++n) {
      const VectorJ b(j, joint.on_j.a_bar[n]);
      for (int k = 0; k < joint.size; ++k)
        if (joint.rows[k].j == n)
          place(k, product_row<Row>(VectorI(i, joint.on_i.a_bar[joint.rows[k].i]), b, Jet<S>{}));
    }
    for (int k = 0; k < joint.size; ++k) {
      if (joint.rows[k].i >= 0) continue;
      const auto& constraint = mechanism_.rows[joint.rows[k].row];
      const BodyPair pair = bodies_of(constraint);
      Row row = evaluate_row(constraint, body_[pair.i], body_[pair.j], t);
      if (pair.i != joint.bodies.i) row.rot_i.swap(row.rot_j);
      place(k, row);
    }
  }

  void assemble_rows(int e, const S& t) {
    const GraphEdge& edge = solver_.plan().graph.edges[e];
    EdgeRows<S>& rows = matrix_.rows[e];
    for (int k = 0; k < edge.size(); ++k) {
      const auto& constraint = mechanism_.rows[edge.rows[k]];
      const BodyPair pair = bodies_of(constraint);
      const Row row = evaluate_row(constraint, body_[pair.i], body_[pair.j], t);
      auto on_i = (pair.i == edge.i ? rows.C_i : rows.C_j).col(k);
      auto on_j = (pair.i == edge.i ? rows.C_j : rows.C_i).col(k);
      on_i.template head<3>() = row.r_i.transpose();
      on_i.template tail<3>() = row.rot_i.transpose();
      on_j.template head<3>() = row.r_j.transpose();
      on_j.template tail<3>() = row.rot_j.transpose();
      right_side_.edge[e][k] = row.gamma;
    }
  }

  void measure_and_add_step() {
    S moved(0), size(0);
    for (int b = 0; b < mechanism_.nb(); ++b) {
      const auto energy = [&](const Vector6<S>& a) {
        const Vector3<S> x = a.template tail<3>();
        return S(mechanism_.bodies[b].mass * a.template head<3>().squaredNorm() + x.dot(matrix_.H[b].xx * x));
      };
      moved += energy(step_.body[b]);
      solution_.body[b] += step_.body[b];
      size += energy(solution_.body[b]);
    }
    WrenchSize lambda_moved, lambda_size;
    const EliminationPlan& plan = solver_.plan();
    for (std::size_t e = 0; e < plan.graph.edges.size(); ++e) solution_.edge[e] += step_.edge[e];
    for (const PointJoint& joint : points_) {
      const PointRows<S>& rows = matrix_.point[joint.link];
      lambda_moved.add(rows, step_.edge[joint.edge], joint.size);
      lambda_size.add(rows, solution_.edge[joint.edge], joint.size);
    }
    for (const int e : general_) {
      const GraphEdge& edge = plan.graph.edges[e];
      const Matrix6<S>& C = edge.j == plan.graph.bodies ? matrix_.rows[e].C_i : matrix_.rows[e].C_j;
      lambda_moved.add(C, step_.edge[e], edge.size());
      lambda_size.add(C, solution_.edge[e], edge.size());
    }
    const auto ratio = [](const S& difference, const S& whole) {
      return largest_lane(difference) == 0 ? 0.0 : std::sqrt(largest_lane(S(difference / whole)));
    };
    corrections_ = {ratio(moved, size), std::max(ratio(lambda_moved.force, lambda_size.force),
                                                 ratio(lambda_moved.moment, lambda_size.moment))};
  }

  /// Sums of squares of what single multipliers do to a body.
  struct WrenchSize {
    S force{0}, moment{0};

    void add(const PointRows<S>& rows, const Vector6<S>& lambda, int orientations) {
      const Vector3<S> f = lambda.template head<3>();
      force += f.squaredNorm();
      moment += (rows.K_child.transpose() * f).squaredNorm();
      for (int k = 0; k < orientations; ++k)
        moment += lambda[3 + k] * lambda[3 + k] * rows.W_child.col(k).squaredNorm();
    }
    void add(const Matrix6<S>& C, const Vector6<S>& lambda, int size) {
      for (int k = 0; k < size; ++k) {
        force += lambda[k] * lambda[k] * C.col(k).template head<3>().squaredNorm();
        moment += lambda[k] * lambda[k] * C.col(k).template tail<3>().squaredNorm();
      }
    }
  };

  template <class Visit>
  void for_each_row(const Visit& visit) const {
    const auto& edges = solver_.plan().graph.edges;
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (int k = 0; k < edges[e].size(); ++k) visit(static_cast<int>(e), k, edges[e].rows[k]);
  }

  const Mechanism<S>& mechanism_;
  GraphSolver<S> solver_;
  GraphMatrix<S> matrix_;
  GraphVector<S> right_side_, solution_, defect_, step_;
  std::vector<Body> body_;  ///< nb + 1, the ground last
  std::vector<Wrench<S>> wrenches_;
  std::vector<BodyMotion<S>> motion_;
  std::vector<PointJoint> points_;
  std::vector<int> general_;  ///< edges that are not point joints of the tree
  Corrections corrections_;
};

template <Formulation F>
std::vector<bool> AccelerationSolver<F>::unique() {
  // a row's size in the units of its multiplier: the acceleration that a unit of it gives its bodies
  const auto& edges = solver_.plan().graph.edges;
  std::vector<bool> flags(mechanism_.nc(), true);
  GraphVector<S> unit(solver_.plan().graph), combination(unit);
  for_each_row([&](int edge, int k, int row) {
    if (!solver_.is_dropped(edge, k)) return;
    flags[row] = false;
    for (Vector6<S>& f : unit.body) f.setZero();
    const EdgeRows<S>& rows = matrix_.rows[edge];
    unit.body[edges[edge].i] -= rows.C_i.col(k);
    unit.body[edges[edge].j] -= rows.C_j.col(k);
    solver_.solve(unit, combination);
    for_each_row([&](int other, int n, int other_row) {
      using std::abs;
      if (abs(combination.edge[other][n]) > S(1e-6)) flags[other_row] = false;
    });
  });
  return flags;
}

}  // namespace trivium
