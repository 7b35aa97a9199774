/// The factorisation alone, on systems of random numbers: any positive definite blocks and any rows, as
/// projections need them. The orientation rows of point joints are an exception: on the child they are drawn
/// well independent, because the axes of a joint are (point_link.hpp).

#include "formulations/structured/graph_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "bodies/rotations/so3.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/testing/random_mechanism.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium {
namespace {

using Columns = PaddedColumns<double, 3>;

/// A system of random numbers on the graph of a random mechanism, in blocks and as a dense matrix.
class RandomSystem {
 public:
  struct Options {
    double rows_apart = 1;  ///< the difference of the last two rows of each edge; 1: they are independent
    /// The same for the last two orientation rows of each point joint. Below 1 the rows on the parent are
    /// those on the child in other axes, as PointLink requires.
    double axes_apart = 1;
    bool has_springs = false;
  };
  explicit RandomSystem(std::uint64_t seed) : RandomSystem(seed, Options{}) {}
  RandomSystem(std::uint64_t seed, const Options& options)
      : random_(seed),
        options_(options),
        plan_(plan_of(seed, options.has_springs)),
        matrix(plan_),
        right_side(plan_.graph) {
    const int bodies = plan_.graph.bodies;
    int size = 6 * bodies;
    for (const GraphEdge& edge : plan_.graph.edges) {
      first_row_.push_back(size);
      size += edge.size();
    }
    dense = MatrixX<double>::Zero(size, size);
    right = VectorX<double>::NullaryExpr(size, [this](Eigen::Index) { return random_.uniform(); });
    for (int b = 0; b < bodies; ++b) fill_block(b);
    for (std::size_t n = 0; n < plan_.links.size(); ++n)
      if (plan_.is_point_link(plan_.links[n])) fill_point(n);
    for (std::size_t e = 0; e < plan_.graph.edges.size(); ++e) {
      if (plan_.rows_slot[e] >= 0) fill_rows(e);
      for (int k = 0; k < plan_.graph.edges[e].size(); ++k) right_side.edge[e][k] = right[first_row_[e] + k];
    }
    if (options.has_springs)
      for (const EliminationPlan::Closing& closing : plan_.closings) give_way(closing.edge);
    for (int b = 0; b < bodies; ++b) right_side.body[b] = BodyPart<double>::of(right.segment<6>(6 * b));
  }

  /// The relative residual of the dense system at the structured solution after a number of refinements.
  double defect(int refinements = 0) const {
    GraphSolver<double> solver(plan_);
    GraphVector<double> solution(plan_.graph);
    solver.factor(matrix);
    solver.solve(right_side, solution);
    GraphVector<double> defect(plan_.graph), step(plan_.graph);
    for (int n = 0; n < refinements; ++n) {
      solver.correct(matrix, right_side, solution, defect, step);
      solution.add(1, step);
    }
    VectorX<double> x(right.size());
    for (int b = 0; b < plan_.graph.bodies; ++b) x.segment<6>(6 * b) = solution.body[b].six();
    for (std::size_t e = 0; e < plan_.graph.edges.size(); ++e)
      for (int k = 0; k < plan_.graph.edges[e].size(); ++k) x[first_row_[e] + k] = solution.edge[e][k];
    return (dense * x - right).norm() / (dense.cwiseAbs() * x.cwiseAbs() + right.cwiseAbs()).norm();
  }

 private:
  static EliminationPlan plan_of(std::uint64_t seed, bool has_springs) {
    BodyJointGraph graph = body_joint_graph(make_mechanism<double>(test::random_scene(
        seed, {.bodies = 2 + static_cast<int>(seed % 5), .closings = static_cast<int>(seed % 3)})));
    // from each body to the next, also where no joint connects the two; from the last body to the ground
    if (has_springs)
      for (int b = 0; b < graph.bodies; ++b) graph.edges.push_back({{b, b + 1}, {-1}, false, true, true});
    for (GraphEdge& edge : graph.edges) edge.is_relative = false;  // random rows see every motion
    return plan_elimination(graph);
  }

  Columns columns(int n) {
    Columns C = Columns::Zero();
    for (int k = 0; k < n; ++k) C.col(k).head<3>() = random_.vector<double, 3>();
    return C;
  }
  static bool are_well_apart(const Columns& C, int n) {
    return n == 0 || Eigen::JacobiSVD<MatrixX<double>>(C.topLeftCorner(3, n)).singularValues()[n - 1] > 0.2;
  }
  void fill_block(int b) {
    Matrix6<double> root;
    for (int k = 0; k < 6; ++k) root.col(k) = random_.vector<double, 6>();
    const Matrix6<double> H = root * root.transpose() + 0.1 * Matrix6<double>::Identity();
    dense.block<6, 6>(6 * b, 6 * b) = H;
    matrix.H[b].rr.topRows<3>() = H.topLeftCorner<3, 3>();
    matrix.H[b].rx.topRows<3>() = H.topRightCorner<3, 3>();
    matrix.H[b].xx.topRows<3>() = H.bottomRightCorner<3, 3>();
  }
  void place(int row, int body, const Vector6<double>& gradient) {
    if (body == plan_.graph.bodies) return;
    dense.block<1, 6>(row, 6 * body) = gradient.transpose();
    dense.block<6, 1>(6 * body, row) = gradient;
  }
  void fill_point(std::size_t n) {
    const EliminationPlan::Link& link = plan_.links[n];
    PointRows<double>& rows = matrix.point[n];
    const int m = plan_.graph.edges[link.edge].size() - 3;
    rows.L_child = columns(3);
    rows.L_parent = columns(3);
    do rows.W_child = columns(m);
    while (!are_well_apart(rows.W_child, m));
    rows.W_parent = columns(m);
    if (options_.axes_apart < 1) {
      if (m > 1) {
        rows.W_child.col(m - 1) *= options_.axes_apart;
        rows.W_child.col(m - 1) += rows.W_child.col(m - 2);
      }
      const Matrix3<double> between = rotation_matrix(random_.euler_parameters<double>());
      for (int k = 0; k < m; ++k) rows.W_parent.col(k).head<3>() = -between * rows.W_child.col(k).head<3>();
    }
    for (int k = 0; k < 3 + m; ++k) {
      const auto gradient = [&](double sign, const Columns& L, const Columns& W) {
        Vector6<double> g = Vector6<double>::Zero();
        if (k < 3) {
          g[k] = sign;
          g.tail<3>() = sign * L.col(k).head<3>();
        } else {
          g.tail<3>() = W.col(k - 3).head<3>();
        }
        return g;
      };
      place(first_row_[link.edge] + k, link.body, gradient(rows.sign, rows.L_child, rows.W_child));
      place(first_row_[link.edge] + k, link.parent, gradient(-rows.sign, rows.L_parent, rows.W_parent));
    }
  }
  void fill_rows(std::size_t e) {
    const GraphEdge& edge = plan_.graph.edges[e];
    EdgeRows<double>& rows = matrix.rows[plan_.rows_slot[e]];
    for (int k = 0; k < edge.size(); ++k) {
      const auto draw = [&](int body, BodyColumns<double>& C) {
        Vector6<double> gradient = random_.vector<double, 6>();
        if (options_.rows_apart < 1 && k > 0 && k == edge.size() - 1) {
          gradient *= options_.rows_apart;
          gradient.head<3>() += C.r.col(k - 1).head<3>();
          gradient.tail<3>() += C.x.col(k - 1).head<3>();
        }
        C.r.col(k).head<3>() = gradient.head<3>();
        C.x.col(k).head<3>() = gradient.tail<3>();
        place(first_row_[e] + k, body, gradient);
      };
      draw(edge.i, rows.C_i);
      draw(edge.j, rows.C_j);
    }
  }

  /// Gives the rows of an edge a random compliance from 1e-8 (stiff) to 1e3 (soft).
  void give_way(int e) {
    EdgeRows<double>& rows = matrix.rows[plan_.rows_slot[e]];
    rows.compliance = std::pow(10, random_.uniform(-8, 3));
    for (int k = 0; k < plan_.graph.edges[e].size(); ++k)
      dense(first_row_[e] + k, first_row_[e] + k) = -rows.compliance;
  }

  test::Random random_;
  Options options_;
  EliminationPlan plan_;
  std::vector<int> first_row_;

 public:
  GraphMatrix<double> matrix;
  GraphVector<double> right_side;
  MatrixX<double> dense;
  VectorX<double> right;
};

TEST(GraphSolver, SolvesAnyPositiveBlocksUnderAnyRows) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) EXPECT_LE(RandomSystem(seed).defect(), 1e-11) << seed;
}

TEST(GraphSolver, SolvesRowsThatAreNearlyTheSame) {
  for (const double apart : {1e-3, 1e-5, 1e-6})
    for (std::uint64_t seed = 0; seed < 100; ++seed)
      EXPECT_LE(RandomSystem(seed, {.rows_apart = apart}).defect(1), 1e-13 / apart)
          << seed << " apart " << apart;
}

TEST(GraphSolver, SolvesPointJointsWhoseAxesAreNearlyTheSame) {
  for (const double apart : {1e-1, 1e-2, 1e-3, 1e-4})
    for (std::uint64_t seed = 0; seed < 200; ++seed)
      EXPECT_LE(RandomSystem(seed, {.axes_apart = apart}).defect(), 1e-13 / apart)
          << seed << " apart " << apart;
}

TEST(GraphSolver, SolvesRowsThatGiveWay) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    EXPECT_LE(RandomSystem(seed, {.has_springs = true}).defect(), 1e-10) << seed;
    EXPECT_LE(RandomSystem(seed, {.has_springs = true}).defect(1), 1e-14) << seed;
  }
}

}  // namespace
}  // namespace trivium
