#pragma once
/// Assembles the system of the structured solver (graph_system.hpp) for one formulation at one state, joint
/// by joint: the matrix, and gamma, Phi and Phi' of every row. Normalisation rows are eliminated in closed
/// form, so each body has three rotational unknowns x. The instances are compiled together with the
/// AccelerationSolver of each formulation.

#include <vector>

#include "constraints/constraint_row.hpp"
#include "formulations/equations_of_motion.hpp"
#include "formulations/structured/graph_system.hpp"
#include "formulations/structured/point_joint.hpp"

namespace trivium {

/// The matrix and the right sides of one mechanism. First move_body() of every body, then the functions that
/// assemble or evaluate rows. An assembly at another state allocates nothing.
template <Formulation F>
class GraphAssembly {
 public:
  using S = typename F::Scalar;
  using Body = typename F::Reduced;

  /// A point joint of the tree.
  struct LinkJoint {
    int link, edge;
    bool child_is_j;
    PointJoint<S, MechanismTypesOf<F>> joint;
  };
  /// A point joint that closes a loop.
  struct ClosingJoint {
    int edge;
    PointJoint<S, MechanismTypesOf<F>> joint;
  };

  /// The mechanism and the plan must outlive the assembly.
  GraphAssembly(const MechanismOf<F>& mechanism, const EliminationPlan& plan);
  GraphAssembly(const MechanismOf<F>&&, const EliminationPlan&) = delete;
  GraphAssembly(const MechanismOf<F>&, const EliminationPlan&&) = delete;
  GraphAssembly(const GraphAssembly&) = delete;  // a GraphSolver keeps a pointer to matrix_

  const GraphMatrix<S>& matrix() const { return matrix_; }
  /// The rows in a slot (EliminationPlan::rows_slot). The caller fills the rows of soft edges: they are
  /// springs and no rows of the mechanism, so the assembly does not know them.
  EdgeRows<S>& edge_rows(int slot) { return matrix_.rows[slot]; }
  /// The bodies at the current state, nb + 1 with the ground last.
  const std::vector<Body>& body() const { return body_; }
  const std::vector<AngularMotion<S>>& angular_motion() const { return angular_motion_; }
  /// The point joints of the tree, in the order of the plan's links.
  const std::vector<LinkJoint>& links() const { return links_; }

  void move_body(int b, const BodyState<F>& state);

  // rows and gamma; to be called after move_body() of all bodies
  void assemble_link(const LinkJoint& link, const S& t, GraphVector<S>& right_side);
  void assemble_closings(const S& t, GraphVector<S>& right_side);

  /// Phi, and Phi' = Phi_q q' - nu, of every row.
  void positions(const S& t, GraphVector<S>& phi) const;
  void velocities(const S& t, GraphVector<S>& phi_dot) const;

  /// Calls mark(edge, k) for the rows that vanish at this state: dp1 rows whose vectors are nearly parallel
  /// (sine below `share`), so that their gradient is nearly zero. This happens where a driven angle reverses.
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
