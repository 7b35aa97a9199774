#pragma once
/// Evaluations and factors of any system: boxes that keep what the system made. A box allocates at its first
/// use, and again only where it is handed to a system of another type.

#include <memory>
#include <stdexcept>

namespace trivium::integrators {

class AnyValue {
 public:
  /// The value, a new one where none of this type is kept.
  template <class T>
  T& as() {
    if (kept_ == nullptr || kept_->type != &type_of<T>) kept_ = std::make_unique<Kept<T>>();
    return static_cast<Kept<T>&>(*kept_).value;
  }
  /// Throws a std::logic_error where none of this type is kept.
  template <class T>
  const T& as() const {
    if (kept_ == nullptr || kept_->type != &type_of<T>) throw_not_made();
    return static_cast<const Kept<T>&>(*kept_).value;
  }

 private:
  [[noreturn, gnu::cold, gnu::noinline]] static void throw_not_made() {
    throw std::logic_error("a value is used before the system made it");
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

class AnyEvaluation : public AnyValue {};
class AnyFactors : public AnyValue {};

}  // namespace trivium::integrators
