/// Assembles the augmented matrix as triplets, and solves it by the solvers of Eigen and SuiteSparse.

#include "validation/cost/sparse.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#ifdef TRIVIUM_COST_SUITESPARSE
#include <Eigen/KLUSupport>
#include <Eigen/UmfPackSupport>
#endif

#include "formulations/equations_of_motion.hpp"
#include "formulations/r_omega.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium::cost {

namespace {

using F = ROmega<double>;
using Sparse = Eigen::SparseMatrix<double>;

/// The printed system of AugmentedSystem, assembled without a dense matrix.
struct System {
  int nb = 0, nc = 0;
  Sparse K;
  VectorX<double> b;
};

System assemble(const EquationsOfMotion<F>& eom) {
  System s;
  s.nb = eom.nb();
  s.nc = eom.nc();
  const int n = 6 * s.nb + s.nc;
  s.b.resize(n);
  std::vector<Eigen::Triplet<double>> entries;
  const auto symmetric = [&](int row, int column, double x) {
    if (x == 0) return;
    entries.emplace_back(row, column, x);
    entries.emplace_back(column, row, x);
  };
  for (int body = 0; body < s.nb; ++body) {
    for (int k = 0; k < 3; ++k) {
      entries.emplace_back(3 * body + k, 3 * body + k, eom.mass[body]);
      for (int l = 0; l < 3; ++l)
        if (eom.mass_block[body](k, l) != 0)
          entries.emplace_back(3 * (s.nb + body) + k, 3 * (s.nb + body) + l, eom.mass_block[body](k, l));
    }
    s.b.segment<3>(3 * body) = eom.F_applied[body];
    s.b.segment<3>(3 * (s.nb + body)) = eom.tau[body];
  }
  for (int row = 0; row < s.nc; ++row) {
    const auto place = [&](int body, const auto& r, const auto& rot) {
      for (int k = 0; k < 3 && body < s.nb; ++k) {
        symmetric(6 * s.nb + row, 3 * body + k, r[k]);
        symmetric(6 * s.nb + row, 3 * (s.nb + body) + k, rot[k]);
      }
    };
    place(eom.pair[row].i, eom.row[row].r_i, eom.row[row].rot_i);
    place(eom.pair[row].j, eom.row[row].r_j, eom.row[row].rot_j);
    s.b[6 * s.nb + row] = eom.row[row].gamma;
  }
  s.K.resize(n, n);
  s.K.setFromTriplets(entries.begin(), entries.end());
  return s;
}

template <class Solver>
class SparseEngine : public Engine {
 public:
  explicit SparseEngine(const scenes::Scene& scene) {
    const auto mechanism = make_mechanism<double>(scene);
    const auto state = to_coordinates<F>(mechanism, make_state<double>(scene), ChartOptions{});
    system_ = assemble(equations_of_motion<F>(mechanism, state, 0.0));
    solver_.analyzePattern(system_.K);
  }

  void evaluate() override {
    solver_.factorize(system_.K);
    if (solver_.info() != Eigen::Success) throw std::runtime_error("finds the matrix singular");
    x_ = solver_.solve(system_.b);
  }

  std::vector<Vector3> r_ddot() override {
    std::vector<Vector3> r_ddot;
    for (int b = 0; b < system_.nb; ++b) r_ddot.push_back({x_[3 * b], x_[3 * b + 1], x_[3 * b + 2]});
    return r_ddot;
  }
  std::vector<double> lambda() override { return {x_.end() - system_.nc, x_.end()}; }

 private:
  System system_;
  Solver solver_;
  VectorX<double> x_;
};

}  // namespace

std::vector<std::string> sparse_solvers() {
  return {"Eigen SparseLU", "Eigen SimplicialLDLT",
#ifdef TRIVIUM_COST_SUITESPARSE
          "SuiteSparse UMFPACK", "SuiteSparse KLU"
#endif
  };
}

std::unique_ptr<Engine> sparse_engine(const scenes::Scene& scene, const std::string& solver) {
  if (solver == "Eigen SparseLU") return std::make_unique<SparseEngine<Eigen::SparseLU<Sparse>>>(scene);
#ifdef TRIVIUM_COST_SUITESPARSE
  if (solver == "SuiteSparse UMFPACK") return std::make_unique<SparseEngine<Eigen::UmfPackLU<Sparse>>>(scene);
  if (solver == "SuiteSparse KLU") return std::make_unique<SparseEngine<Eigen::KLU<Sparse>>>(scene);
#endif
  return std::make_unique<SparseEngine<Eigen::SimplicialLDLT<Sparse>>>(scene);
}

}  // namespace trivium::cost
