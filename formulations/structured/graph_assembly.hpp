#pragma once
/// The system along the graph of one formulation at one state: its matrix, and gamma, Phi and Phi' as right
/// sides, joint by joint. Normalisation rows are eliminated in closed form. Made once per mechanism; moving
/// to another state allocates nothing. Compiled with the AccelerationSolver of the formulation.

#include <vector>

#include "constraints/constraint_row.hpp"
#include "formulations/equations_of_motion.hpp"
#include "formulations/structured/graph_system.hpp"
#include "formulations/structured/point_joint.hpp"

namespace trivium {

template <Formulation F>
class GraphAssembly {
 public:
  using S = typename F::Scalar;
  using Body = typename F::Reduced;

  /// A point joint of the tree, and one that closes a loop.
  struct LinkJoint {
    int link, edge;
    bool child_is_j;
    PointJoint<S, MechanismTypesOf<F>> joint;
  };
  struct ClosingJoint {
    int edge;
    PointJoint<S, MechanismTypesOf<F>> joint;
  };

  /// Both must outlive the assembly.
  GraphAssembly(const MechanismOf<F>& mechanism, const EliminationPlan& plan);
  GraphAssembly(const MechanismOf<F>&&, const EliminationPlan&) = delete;
  GraphAssembly(const MechanismOf<F>&, const EliminationPlan&&) = delete;
  GraphAssembly(const GraphAssembly&) = delete;  // solvers know where its matrix is

  const GraphMatrix<S>& matrix() const { return matrix_; }
  /// For the rows of soft edges, which are not a mechanism's.
  EdgeRows<S>& edge_rows(int slot) { return matrix_.rows[slot]; }
  /// nb + 1, the ground last.
  const std::vector<Body>& body() const { return body_; }
  const std::vector<AngularMotion<S>>& angular_motion() const { return angular_motion_; }
  /// In the order of the plan's links.
  const std::vector<LinkJoint>& links() const { return links_; }

  void move_body(int b, const BodyState<F>& state);

  // rows and gamma, after all bodies have moved
  void assemble_link(const LinkJoint& link, const S& t, GraphVector<S>& right_side);
  void assemble_closings(const S& t, GraphVector<S>& right_side);

  /// Phi, and Phi' = Phi_q q' - nu, of every row.
  void positions(const S& t, GraphVector<S>& phi) const;
  void velocities(const S& t, GraphVector<S>& phi_dot) const;

  /// Calls mark(edge, k) for rows that do next to nothing here, less than `share` of what their vectors
  /// could: a dp1 whose vectors are nearly parallel, as where the angle that it drives turns back.
  template <class Mark>
  void find_vanishing_rows(const S& share, const Mark& mark) const;

 private:
  void set_mass_block(int b);

  void assemble_closing(const ClosingJoint& closing, const S& t, GraphVector<S>& right_side);

  void assemble_rows(int e, const S& t, GraphVector<S>& right_side);

  template <class Of>
  void rows_of(int e, const Of& of, const S& t, GraphVector<S>& values) const;

  const MechanismOf<F>& mechanism_;
  const EliminationPlan& plan_;
  GraphMatrix<S> matrix_;
  std::vector<Body> body_;
  std::vector<AngularMotion<S>> angular_motion_;
  std::vector<LinkJoint> links_;
  std::vector<ClosingJoint> closings_;
  std::vector<int> others_;  ///< edges that are not point joints
};

}  // namespace trivium
