#pragma once
/// The equations of motion at one (t, y), as a value: the bodies in that state, their rows and mass blocks.

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "simulation/system/constraint_violation.hpp"
#include "simulation/system/spring_rows.hpp"

namespace trivium {

/// The contents of an evaluation.
template <Formulation F>
struct EvaluatedModel {
  using S = typename F::Scalar;

  std::shared_ptr<const EliminationPlan> plan;
  GraphAssembly<F> assembly;
  ConstraintViolation<S> violation;
  typename SpringRows<F>::Sizes spring_sizes;
  S t{0};
  bool is_assembled = false;  ///< rows and mass blocks are those of the current body states
  bool is_factored = false;   ///< factors use the matrix: it must not change any more

  EvaluatedModel(const MechanismOf<F>& mechanism, std::shared_ptr<const EliminationPlan> of,
                 const ConstraintViolation<S>& measure)
      : plan(std::move(of)), assembly(mechanism, *plan), violation(measure) {}
  const std::vector<typename F::Reduced>& body() const { return assembly.body(); }
};

/// Owner of an EvaluatedModel. Factors of Newton's matrix share the storage of the evaluation that they were
/// made from. While they do so, a later evaluation takes spare storage: nothing is copied and, after the
/// first steps, nothing allocated. Access before `begin` throws a std::logic_error.
template <Formulation F>
class Evaluation {
 public:
  /// Storage for the next state: the current or the spare storage if it has the same plan and no factors use
  /// it; otherwise a new one from `make()`.
  template <class Make>
  EvaluatedModel<F>& begin(const std::shared_ptr<const EliminationPlan>& plan, const Make& make) {
    const auto is_free = [&] { return model_ && model_.use_count() == 1 && model_->plan == plan; };
    if (!is_free()) std::swap(model_, spare_);
    if (!is_free()) model_ = make();
    model_->is_assembled = model_->is_factored = false;
    return *model_;
  }
  EvaluatedModel<F>& operator*() const {
    if (!model_) throw_not_made();
    return *model_;
  }
  EvaluatedModel<F>* operator->() const { return &**this; }
  const std::shared_ptr<EvaluatedModel<F>>& shared() const { return model_; }

 private:
  [[noreturn, gnu::cold, gnu::noinline]] static void throw_not_made() {
    throw std::logic_error("an evaluation is used before it has been computed");
  }

  std::shared_ptr<EvaluatedModel<F>> model_, spare_;
};

}  // namespace trivium
