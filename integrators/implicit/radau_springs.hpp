#pragma once
/// Springs and dampers in a Newton correction of Radau IIA. The matrix of a stage is real: in it a spring
/// resists with h gamma C + (h gamma)^2 K, where gamma is the real eigenvalue of A. The method asks for h A C
/// + h^2 A^2 K, which couples the stages.

#include <algorithm>

#include "integrators/implicit/conjugate_residuals.hpp"
#include "integrators/implicit/radau_stages.hpp"

namespace trivium::integrators {

/// Solves for the difference between the two resistances iteratively, with one unknown per spring and stage.
/// The iteration needs linear solves but no evaluation of the model.
template <HasSprings System, int s>
requires HasInternalRows<System>
class RadauSprings {
 public:
  using S = typename System::Scalar;
  using Stages = RadauStages<System, s>;
  using Stage = typename Stages::Stage;

  void begin(System& system) { system.spring_constants(stiffness_, damping_); }
  Eigen::Index size() const { return stiffness_.size(); }

  /// The matrices were factored again; in them a spring resists with share C + share^2 K.
  void refactor(const S& share) {
    spring_corrections_.clear();
    resistance_ = share * damping_ + share * share * stiffness_;
  }

  /// Solves for the changes of v' and lambda of all stages. A stage's matrix lets a spring resist the stretch
  /// of that stage alone, where A asks for a mixture of the stretches of all stages. A slack per spring and
  /// stage corrects the difference. The solution is linear in the slacks. Its changes by earlier slacks are
  /// therefore kept until the matrices change, and every later call begins with a combination of them.
  void solve_together(System& system, const S& h, Stages& stages, StateVector<S>& change) {
    const auto& coefficients = stages.coefficients();
    const Eigen::Index springs = size();
    const int nv = stages.nv(), nc = stages.nc();
    given_.resize(s * springs);
    for (int i = 0; i < s; ++i) {
      // forces of the springs by the change of the shift, which moves positions directly
      given_.segment(i * springs, springs) =
          h * stiffness_.cwiseProduct(stages.mixed(coefficients.a[i], &Stage::stretch));
      stages[i].rows = stages.mixed(coefficients.inverse[i], &Stage::phi_dot) / -h;
    }
    const auto put_into = [nv, nc](StateVector<S>& all) {
      return [nv, nc, &all](int i, const StateVector<S>& x, const StateVector<S>& mu) {
        all.segment(i * nv, nv) = x;
        all.segment(s * nv + i * nc, nc) = mu;
      };
    };
    stages.solve_each(
        system, [&](int i) -> const StateVector<S>& { return stages[i].left; }, put_into(change));
    if (springs == 0) return;
    measure(h, stages, spring_residual_);
    spring_residual_ -= given_;
    // 1 % is enough, as the next Newton iteration evaluates the remaining error anew
    const S enough = S(1e-2) * std::max(spring_residual_.cwiseAbs().maxCoeff(), given_.cwiseAbs().maxCoeff());
    auto unknowns = change.head(s * (nv + nc));
    spring_corrections_.reduce(spring_residual_, unknowns);
    for (Stage& stage : stages) stage.rows.setZero();
    no_force_.setZero(nv);
    direction_.resize(s * (nv + nc));
    for (int k = 0; k < most_corrections && spring_residual_.cwiseAbs().maxCoeff() > enough; ++k) {
      for (int i = 0; i < s; ++i)
        stages[i].slack = spring_residual_.segment(i * springs, springs).cwiseQuotient(resistance_);
      stages.solve_each(
          system, [&](int) -> const StateVector<S>& { return no_force_; }, put_into(direction_));
      measure(h, stages, image_);
      if (!spring_corrections_.keep(direction_, image_)) break;
      spring_corrections_.reduce(spring_residual_, unknowns);
    }
  }

 private:
  /// Chosen by experiment: with fewer directions springs of different stiffness stay unsolved, more
  /// directions cost linear solves and rarely help.
  static constexpr int most_corrections = 4 * s;

  /// Spring forces in the stages' matrices less those that A asks for [N, N m].
  void measure(const S& h, const Stages& stages, StateVector<S>& residual) const {
    const auto& coefficients = stages.coefficients();
    const Eigen::Index springs = size();
    residual.resize(s * springs);
    for (int i = 0; i < s; ++i)
      residual.segment(i * springs, springs) =
          resistance_.cwiseProduct(stages[i].stretch - stages[i].slack) -
          h * damping_.cwiseProduct(stages.mixed(coefficients.a[i], &Stage::stretch)) -
          h * h * stiffness_.cwiseProduct(stages.mixed(coefficients.square[i], &Stage::stretch));
  }

  ConjugateResiduals<S> spring_corrections_;
  StateVector<S> stiffness_, damping_, resistance_;
  StateVector<S> given_, spring_residual_, direction_, image_;  ///< all stages, one after the other
  StateVector<S> no_force_;
};

}  // namespace trivium::integrators
