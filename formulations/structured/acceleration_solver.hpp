#pragma once
/// Accelerations and multipliers of one formulation in O(nb). The augmented system, with the normalisation
/// rows eliminated in closed form, is assembled joint by joint (graph_assembly.hpp) and solved along the
/// graph of bodies and joints (graph_solver.hpp). One object serves one mechanism. Its plan is made once. A
/// solution at another state allocates nothing, unless candidates (see below) are examined for the first time
/// or more rows than before are put back.
///
/// The elimination leaves out the rows whose pivots are small, the candidates: their multiplier is 0. A
/// candidate may still be independent, by a small sine. If there is a reason, the candidates are examined,
/// and the independent ones are put back. The other candidates are the dependent rows
/// (docs/linear_time_solver.md).
///
/// The library has every formulation in double and Quad (instances/). For another Scalar, and
/// for your own formulations, constraints or effects, include acceleration_solver_impl.hpp and
/// graph_solver_impl.hpp.

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "formulations/structured/baumgarte.hpp"
#include "formulations/structured/graph_assembly.hpp"
#include "formulations/structured/graph_solver.hpp"
#include "formulations/structured/row_violation.hpp"

namespace trivium {

/// The size [0 to 1] of the last correction by refinement, relative to the solution. Accelerations are
/// measured in the mass metric. Multipliers are measured by the forces and by the moments that they exert:
/// `lambda` is the larger of these two ratios. The correction estimates the error before that refinement,
/// over the whole mechanism. The relative error of a body far lighter than the others may be larger. If
/// forces are in balance, the accelerations are rounding error and their correction may be 1.
struct Corrections {
  double acceleration = 0, lambda = 0;
};

/// as_needed: one step of refinement, and further steps as long as the corrections fall and the next one is
/// predicted to exceed 1e-4 u. In double a second step is made if the first correction exceeds about 2e-10,
/// for example if a light body carries a heavy one.
enum class Refinement { none, as_needed };

/// Solves the equations of one mechanism in the formulation F, at one state after the other.
template <Formulation F>
class AccelerationSolver {
 public:
  using S = typename F::Scalar;
  using Body = typename F::Reduced;

  /// The mechanism must outlive the solver.
  explicit AccelerationSolver(const MechanismOf<F>& mechanism);
  explicit AccelerationSolver(const MechanismOf<F>&&) = delete;
  AccelerationSolver(const AccelerationSolver&) = delete;  // solver_ keeps a pointer to the matrix

  /// Solves at a state: one BodyState per body (to_coordinates) at time t [s]. `how` decides which rows are
  /// dependent. Throws a ModelError that names the body if a link is singular, and the row if a dependent row
  /// contradicts the others or if too many candidates are independent. After an error all results are NaN.
  void solve(std::span<const BodyState<F>> state, const S& t, Refinement refinement = Refinement::as_needed,
             DependentRows how = DependentRows::detect);

  /// Imposes Phi'' + 2 alpha Phi' + beta^2 Phi = 0 in place of Phi'' = 0 in all solutions from now on.
  void stabilise(const Baumgarte& baumgarte);

  /// One step of iterative refinement.
  void refine();

  /// The mechanism that the solver was made for.
  const MechanismOf<F>& mechanism() const { return mechanism_; }
  /// The order of elimination, common to all states.
  const EliminationPlan& plan() const { return solver_.plan(); }
  /// The factors of the last state, to solve for other right sides. If another matrix is factored with this
  /// object, the accelerations become invalid.
  GraphSolver<S>& factors() { return solver_; }
  /// The matrix and the bodies of the last state.
  GraphAssembly<F>& assembly() { return assembly_; }
  const GraphAssembly<F>& assembly() const { return assembly_; }
  /// The error of a singular link with the name of its body. If the state is not finite, throws the error of
  /// the state instead, since the state is the cause.
  ModelError named(const SingularLink& link, const S& t) const;
  /// The corrections by the last step of refinement.
  const Corrections& corrections() const { return corrections_; }

  /// Acceleration of the centre of mass of body b [m/s^2, global].
  Vector3<S> r_ddot(int b) const { return unpadded<S>(solution_.body[b].r); }
  /// The formulation's own rotational unknown of body b: omega_bar' [rad/s^2, body frame] in r-omega, p''
  /// [1/s^2] in r-p, epsilon'' [rad/s^2] in r-epsilon.
  typename F::Unknown q_ddot(int b) const {
    return F::from_reduced(assembly_.body()[b], unpadded<S>(solution_.body[b].x));
  }
  /// Angular acceleration of body b [rad/s^2, body frame].
  Vector3<S> omega_bar_dot(int b) const {
    return F::omega_bar_dot_from_reduced(assembly_.body()[b], unpadded<S>(solution_.body[b].x));
  }
  /// [nc] One multiplier per row of the mechanism [N for rows of lengths, N m for rows of angles; else J per
  /// unit of the row]; 0 in dependent rows.
  VectorX<S> lambda() const {
    VectorX<S> all(mechanism_.nc());
    copy_lambda(all);
    return all;
  }
  /// Writes lambda() into a vector of size nc.
  void copy_lambda(VectorX<S>& all) const {
    for_each_row([&](int edge, int k, int row) { all[row] = solution_.edge[edge][k]; });
  }
  /// [nb + 1] The wrenches of the effects at the state, per body, the ground last: force [N] global, moment
  /// [N m] about the centre of mass, body frame.
  const std::vector<Wrench<S>>& loads() const { return wrenches_; }
  /// The indices of the dependent rows, ascending. If solve() had no reason to examine the candidates, they
  /// are examined here. A candidate that is put back gets a multiplier in place of 0, and the state is solved
  /// again.
  std::vector<int> dependent_rows();
  /// The number of rows that vanish, and of those that would be dependent or weak if every body had unit
  /// inertia (GraphSolver). Cost: about two factorisations.
  int weak_rows_by_geometry();
  /// The number of independent rows.
  int rank() { return mechanism_.nc() - static_cast<int>(dependent_rows().size()); }

  // on demand: these cost one solution per dependent row, unique() one factorisation besides, and allocate
  // memory

  /// By row, whether its multiplier is unique: the row has a gradient, and its component is 0 in every null
  /// space vector of Phi_q^T.
  std::vector<bool> unique();
  /// The lambda of minimum |E lambda| among all with the same Phi_q^T lambda, where E = diag(Phi_q M^-1
  /// Phi_q^T)^(1/2). If there are dependent rows and an inertia is singular, throws a ModelError that names
  /// the body.
  VectorX<S> minimum_norm_lambda();

 private:
  void move_bodies(std::span<const BodyState<F>> state);
  void push_body(int b);
  void apply_effects();
  void measure_violations();
  void stabilise(int edge);

  /// Assembles the rows of the closings, and begins to factor and to eliminate.
  void start(DependentRows how);
  /// Factors and eliminates link by link. Each joint is evaluated just before its step.
  void eliminate();
  /// Under detect_near_singular: exchanges rows of weak pivots, if as many rows stay independent without
  /// them.
  void exchange_weak_rows();
  void assemble_link(const typename GraphAssembly<F>::LinkJoint& link);

  // refinement (refinement_impl.hpp)

  /// Refines until the predicted next correction is far below u, or until the corrections stop falling.
  void refine_as_needed();
  void measure_and_add_step();

  // dependent rows (dependent_rows_check_impl.hpp)

  /// Checks the right sides of the dependent rows. If a row is a combination of other rows, its gamma must be
  /// the same combination of the gammas of these rows. If the solution violates candidates, they are examined
  /// and the independent ones put back. Throws a ModelError if a dependent row contradicts the others.
  void check_dependent_rows();
  template <class SizeOfBody>
  std::optional<EdgeRow> find_violated_row(const GraphVector<S>& solution, const S& tolerance, const S& least,
                                           const SizeOfBody& size_of_body) const;
  /// The largest of three: the accelerations of the body, those that its forces alone would cause, and those
  /// that its angular velocity alone would cause. The body's accelerations alone give no scale, because they
  /// are rounding errors if forces are in balance.
  AccelerationSize<S> size_of_causes(int b) const;
  /// omega^2 in place of an angular acceleration. The velocity terms of gamma have the size of omega^2 times
  /// a lever, and the gradient of a row by rotations contains this lever.
  AccelerationSize<S> size_of_turning(int b) const {
    return {S(0), assembly_.angular_motion()[b].omega.squaredNorm()};
  }
  /// Examines the candidates, once per state. Puts the independent ones back and, if there are any, solves
  /// again.
  void decide_dependent_rows();
  Place place_of(const EdgeRow& row) const;
  [[noreturn]] void throw_violated(const EdgeRow& row) const;

  // unique multipliers (unique_multipliers_impl.hpp)

  /// A basis of the null space of Phi_q^T [nc x number of dependent rows].
  MatrixX<S> left_null_space();
  /// By row, the sum over its bodies of norm2(body, r, x), where (r, x) is the row's gradient on the body.
  template <class Norm2>
  VectorX<S> row_sizes(const Norm2& norm2) const;

  /// Throws a ModelError that names the body if its state is not finite.
  void require_numbers() const;
  /// Sets all results to NaN, so that after an error no result of an earlier state is taken for a new one.
  void forget();

  template <class Visit>
  void for_each_row(const Visit& visit) const {
    const auto& edges = solver_.plan().graph.edges;
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (int k = 0; k < edges[e].size(); ++k) visit(static_cast<int>(e), k, edges[e].rows[k]);
  }

  const MechanismOf<F>& mechanism_;
  GraphSolver<S> solver_;
  GraphAssembly<F> assembly_;
  GraphVector<S> right_side_, solution_, residual_, step_;
  std::vector<Wrench<S>> wrenches_;  ///< nb + 1, the ground last; motion_ likewise
  std::vector<BodyMotion<S>> motion_;
  /// The edges whose rows may be dependent: all except the point joints of the tree.
  std::vector<int> candidate_edges_;
  // of the last solution
  S t_{0};
  Refinement refinement_ = Refinement::as_needed;
  bool rows_are_decided_ = false;  ///< the candidates have been examined, or never are
  Corrections corrections_;
  // for Baumgarte's stabilisation only
  std::optional<Baumgarte> baumgarte_;
  std::optional<GraphVector<S>> phi_, phi_dot_;
};

}  // namespace trivium
