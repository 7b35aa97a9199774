#pragma once
/// Accelerations and multipliers of one formulation in O(nb): the augmented system with its normalisation
/// rows eliminated in closed form, assembled joint by joint and solved along the body-joint graph. One object
/// per mechanism, planned once; solving again at another state allocates nothing.
///
/// The library has every formulation in double and Quad (instances/). For another Scalar include
/// acceleration_solver_impl.hpp and graph_solver_impl.hpp.

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

/// What the last refinement corrected, relative: accelerations in the mass metric; multipliers by the forces
/// and by the moments that they exert, whichever is worse. It is the error before that refinement, over the
/// whole mechanism: of a body far lighter than others it may be more; what is left is smaller. Where forces
/// in balance leave no acceleration, all of it is correction.
struct Corrections {
  double acceleration = 0, lambda = 0;
};

/// As needed: once, and again where the corrections say that more than rounding is left, as where a light
/// body holds a heavy one.
enum class Refinement { none, as_needed };

template <Formulation F>
class AccelerationSolver {
 public:
  using S = typename F::Scalar;
  using Body = typename F::Reduced;

  /// The mechanism must outlive the solver.
  explicit AccelerationSolver(const MechanismOf<F>& mechanism);
  explicit AccelerationSolver(const MechanismOf<F>&&) = delete;
  AccelerationSolver(const AccelerationSolver&) = delete;  // its solver knows where its matrix is

  /// Solves at a state. Throws a ModelError that names the body where a link is singular, and the row where
  /// a dependent row contradicts the others; all answers are NaN then.
  void solve(std::span<const BodyState<F>> state, const S& t, Refinement refinement = Refinement::as_needed,
             DependentRows how = DependentRows::detect);

  /// From now on accelerations are those of the stabilised rows.
  void stabilise(const Baumgarte& baumgarte);

  /// One step of iterative refinement.
  void refine();

  const MechanismOf<F>& mechanism() const { return mechanism_; }
  const EliminationPlan& plan() const { return solver_.plan(); }
  /// For other right sides of the same matrix; what is done to them voids the accelerations.
  GraphSolver<S>& factors() { return solver_; }
  GraphAssembly<F>& assembly() { return assembly_; }
  const GraphAssembly<F>& assembly() const { return assembly_; }
  /// What went wrong at a link, with its body's name; that of a state that is not finite comes first.
  ModelError named(const SingularLink& link, const S& t) const;
  /// Of the last refinement.
  const Corrections& corrections() const { return corrections_; }

  Vector3<S> r_ddot(int b) const { return unpadded<S>(solution_.body[b].r); }
  /// The formulation's own unknown.
  typename F::Unknown q_ddot(int b) const {
    return F::from_reduced(assembly_.body()[b], unpadded<S>(solution_.body[b].x));
  }
  Vector3<S> omega_bar_dot(int b) const { return F::to_angular_acceleration(assembly_.body()[b], q_ddot(b)); }
  /// One multiplier per row of the mechanism; 0 in dependent rows.
  VectorX<S> lambda() const {
    VectorX<S> all(mechanism_.nc());
    copy_lambda(all);
    return all;
  }
  /// The same into a vector of that size.
  void copy_lambda(VectorX<S>& all) const {
    for_each_row([&](int edge, int k, int row) { all[row] = solution_.edge[edge][k]; });
  }
  /// Which rows depend on others is decided here where the solution left it open; multipliers of rows that do
  /// not may then change from 0, within what rounding leaves of them.
  std::vector<int> dependent_rows();
  int rank() { return mechanism_.nc() - static_cast<int>(dependent_rows().size()); }

  // on demand, one solve per dependent row; not for the timed path

  /// Which multipliers are unique: those that no combination that acts on nothing contains.
  std::vector<bool> unique();
  /// Lambda of minimum |E lambda| among those with the same Phi^T lambda, E = diag(Phi M^-1 Phi^T)^(1/2).
  /// Throws a ModelError that names the body where M is singular and the choice matters.
  VectorX<S> minimum_norm_lambda();

 private:
  void move_bodies(std::span<const BodyState<F>> state);
  void push_body(int b);
  void apply_effects();
  void measure_violations();
  void stabilise(int edge);

  /// Link by link, each joint evaluated just before its step.
  void eliminate();
  void assemble_link(const typename GraphAssembly<F>::LinkJoint& link);

  // refinement (refinement_impl.hpp)

  /// Until what is left, as far as the corrections fall alike, is far below rounding; or they fall no more.
  void refine_as_needed();
  void measure_and_add_step();

  // dependent rows (dependent_rows_check_impl.hpp)

  /// Dependent rows are combinations of the others, so that their right sides must be the same combinations;
  /// or they are none, and are solved for then.
  void check_dependent_rows();
  template <class SizeOfBody>
  std::optional<EdgeRow> find_violated_row(const GraphVector<S>& solution, const S& tolerance, const S& least,
                                           const SizeOfBody& size_of_body) const;
  /// Of a body's accelerations, and of what its forces and its turning could cause: forces in balance leave
  /// accelerations that are rounding.
  AccelerationSize<S> size_of_causes(int b) const;
  /// With levers, what gamma is made of.
  AccelerationSize<S> size_of_turning(int b) const {
    return {S(0), assembly_.angular_motion()[b].omega.squaredNorm()};
  }
  /// Tells rows that depend on others from those that nearly do, and solves for these as well; once a state.
  void decide_dependent_rows();
  Place place_of(const EdgeRow& row) const;
  [[noreturn]] void throw_violated(const EdgeRow& row) const;

  // unique multipliers (unique_multipliers_impl.hpp)

  /// Null space of Phi^T, a column per dependent row.
  MatrixX<S> left_null_space();
  /// Per row the sum over its bodies of norm2(body, r, x) of what the row does there.
  template <class Norm2>
  VectorX<S> row_sizes(const Norm2& norm2) const;

  /// Throws a ModelError that names the body whose state is not a number.
  void require_numbers() const;
  /// No answer of another state may be taken for one of this.
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
  std::vector<Wrench<S>> wrenches_;  ///< nb + 1, the ground's last, and so
  std::vector<BodyMotion<S>> motion_;
  /// Edges whose rows may be dependent: all but the point joints of the tree.
  std::vector<int> candidate_edges_;
  // of the last state
  S t_{0};
  Refinement refinement_ = Refinement::as_needed;
  bool rows_are_decided_ = false;  ///< the dependent ones all depend on others
  Corrections corrections_;
  // where rows are stabilised
  std::optional<Baumgarte> baumgarte_;
  std::optional<GraphVector<S>> phi_, phi_dot_;
};

}  // namespace trivium
