#pragma once
/// Type erasure of the values Evaluation and Factors of a system. The erased value is a box, which allocates
/// at its first use, and again only when a system of another type uses it.

#include <memory>
#include <stdexcept>

namespace trivium::integrators {

/// A box that holds a value of any default-constructible type.
class AnyValue {
 public:
  /// The value of type T; makes a new one if the box is empty or holds another type.
  template <class T>
  T& as() {
    if (kept_ == nullptr || kept_->type != &type_of<T>) kept_ = std::make_unique<Kept<T>>();
    return static_cast<Kept<T>&>(*kept_).value;
  }
  /// Throws a std::logic_error if the box does not hold a T.
  template <class T>
  const T& as() const {
    if (kept_ == nullptr || kept_->type != &type_of<T>) throw_not_made();
    return static_cast<const Kept<T>&>(*kept_).value;
  }

 private:
  [[noreturn, gnu::cold, gnu::noinline]] static void throw_not_made() {
    throw std::logic_error("an evaluation is used before the system has computed it");
  }

  template <class T>
  static constexpr char type_of = 0;

  struct KeptBase {
    explicit KeptBase(const char* of) : type(of) {}
    virtual ~KeptBase() = default;
    const char* type;
  };
  template <class T>
  struct Kept final : KeptBase {
    Kept() : KeptBase(&type_of<T>) {}
    T value;
  };

  std::unique_ptr<KeptBase> kept_;
};

/// The Evaluation of any system. AnyFactors is a type of its own, so that the two cannot be confused.
class AnyEvaluation : public AnyValue {};
/// The Factors of any system.
class AnyFactors : public AnyValue {};

}  // namespace trivium::integrators
