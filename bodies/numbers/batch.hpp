#pragma once
/// `Batch<T, N>`: a scalar type that holds N numbers of type T, its lanes. Code over Batch computes N states
/// at once, of one mechanism or of N mechanisms of equal structure, with the processor's vector instructions.

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "bodies/numbers/compiled_with.hpp"
#include "bodies/numbers/lanewise.hpp"

namespace trivium {

/// Number of values of type T in one vector register of the processor that this build targets.
template <class T>
inline constexpr int native_lanes =
#if defined(__AVX512F__)
    64 / sizeof(T);
#elif defined(__AVX__)
    32 / sizeof(T);
#else
    16 / sizeof(T);
#endif

/// N numbers of type T. Every operation acts on each lane alone. The results therefore equal those of N
/// separate computations, except where the compiler fuses a multiplication and an addition into one rounding.
template <class T, int N>
class Batch {
 public:
  static constexpr int lanes = N;
  using Lanes [[gnu::vector_size(sizeof(T) * N)]] = T;

  /// Result of a comparison, one truth value per lane. In an `if` all lanes must agree; otherwise the
  /// conversion to bool throws MixedLanes.
  class Mask {
   public:
    using Bits = decltype(Lanes{} < Lanes{});
    explicit Mask(const Bits& bits) : bits_(bits) {}
    const Bits& bits() const { return bits_; }

    bool any() const {
      bool some = false;
      for (int k = 0; k < N; ++k) some = some || bits_[k] != 0;
      return some;
    }
    bool all() const {
      bool every = true;
      for (int k = 0; k < N; ++k) every = every && bits_[k] != 0;
      return every;
    }
    operator bool() const {  // NOLINT: implicit, so that code written for plain numbers compiles
      if (all()) return true;
      if (any()) throw MixedLanes();
      return false;
    }

   private:
    Bits bits_;
  };

  Batch() = default;
  template <class Number>
  requires std::is_arithmetic_v<Number> Batch(Number value) {  // NOLINT: implicit; same value in all lanes
    for (int k = 0; k < N; ++k) lanes_[k] = static_cast<T>(value);
  }

  T operator[](int lane) const { return lanes_[lane]; }
  void set(int lane, T value) { lanes_[lane] = value; }
  /// The value of the first lane, for messages.
  explicit operator double() const { return static_cast<double>(lanes_[0]); }

  Batch operator-() const { return Batch(-lanes_, 0); }
  Batch& operator+=(const Batch& b) { return lanes_ += b.lanes_, *this; }
  Batch& operator-=(const Batch& b) { return lanes_ -= b.lanes_, *this; }
  Batch& operator*=(const Batch& b) { return lanes_ *= b.lanes_, *this; }
  Batch& operator/=(const Batch& b) { return lanes_ /= b.lanes_, *this; }
  friend Batch operator+(const Batch& a, const Batch& b) { return Batch(a.lanes_ + b.lanes_, 0); }
  friend Batch operator-(const Batch& a, const Batch& b) { return Batch(a.lanes_ - b.lanes_, 0); }
  friend Batch operator*(const Batch& a, const Batch& b) { return Batch(a.lanes_ * b.lanes_, 0); }
  friend Batch operator/(const Batch& a, const Batch& b) { return Batch(a.lanes_ / b.lanes_, 0); }

  friend Mask operator<(const Batch& a, const Batch& b) { return Mask(a.lanes_ < b.lanes_); }
  friend Mask operator>(const Batch& a, const Batch& b) { return Mask(a.lanes_ > b.lanes_); }
  friend Mask operator<=(const Batch& a, const Batch& b) { return Mask(a.lanes_ <= b.lanes_); }
  friend Mask operator>=(const Batch& a, const Batch& b) { return Mask(a.lanes_ >= b.lanes_); }
  friend Mask operator==(const Batch& a, const Batch& b) { return Mask(a.lanes_ == b.lanes_); }
  friend Mask operator!=(const Batch& a, const Batch& b) { return Mask(a.lanes_ != b.lanes_); }

  friend Mask either(const Mask& a, const Mask& b) { return Mask(a.bits() | b.bits()); }
  friend Batch select(const Mask& condition, const Batch& a, const Batch& b) {
    return Batch(condition.bits() ? a.lanes_ : b.lanes_, 0);
  }
  friend bool any(const Mask& condition) { return condition.any(); }
  friend bool all(const Mask& condition) { return condition.all(); }
  /// The minimum over the lanes.
  friend T least_lane(const Batch& x) {
    T least = x[0];
    for (int k = 1; k < N; ++k) least = x[k] < least ? x[k] : least;
    return least;
  }

  /// The maximum over the lanes; NaN if a lane is NaN.
  friend double largest_lane(const Batch& x) {
    T largest = x[0];
    for (int k = 1; k < N; ++k) largest = largest >= x[k] || std::isnan(largest) ? largest : x[k];
    return static_cast<double>(largest);
  }

  friend Batch abs(const Batch& x) { return select(x < Batch(0), -x, x); }
  friend Batch abs2(const Batch& x) { return x * x; }
  friend Batch sqrt(const Batch& x) {
    return each(x, [](T v) { return std::sqrt(v); });
  }
  friend Batch sin(const Batch& x) {
    return each(x, [](T v) { return std::sin(v); });
  }
  friend Batch cos(const Batch& x) {
    return each(x, [](T v) { return std::cos(v); });
  }
  friend Batch acos(const Batch& x) {
    return each(x, [](T v) { return std::acos(v); });
  }
  friend Batch atan2(const Batch& y, const Batch& x) {
    Batch out;
    for (int k = 0; k < N; ++k) out.lanes_[k] = std::atan2(y[k], x[k]);
    return out;
  }
  friend bool isfinite(const Batch& x) {
    bool every = true;
    for (int k = 0; k < N; ++k) every = every && std::isfinite(x[k]);
    return every;
  }

 private:
  Batch(const Lanes& values, int) : lanes_(values) {}
  template <class Function>
  static Batch each(const Batch& x, const Function& f) {
    Batch out;
    for (int k = 0; k < N; ++k) out.lanes_[k] = f(x[k]);
    return out;
  }

  Lanes lanes_;
};

}  // namespace trivium

namespace std {
/// The limits of T, in every lane.
template <class T, int N>
class numeric_limits<trivium::Batch<T, N>> : public numeric_limits<T> {
  using Batch = trivium::Batch<T, N>;
  using Base = numeric_limits<T>;

 public:
  static Batch min() { return Base::min(); }
  static Batch max() { return Base::max(); }
  static Batch lowest() { return Base::lowest(); }
  static Batch epsilon() { return Base::epsilon(); }
  static Batch infinity() { return Base::infinity(); }
  static Batch quiet_NaN() { return Base::quiet_NaN(); }
};
}  // namespace std

namespace Eigen {
/// Eigen's traits of a Batch: those of T.
template <class T, int N>
struct NumTraits<trivium::Batch<T, N>> : GenericNumTraits<T> {
  using Real = trivium::Batch<T, N>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
  static Real epsilon() { return std::numeric_limits<T>::epsilon(); }
  static Real dummy_precision() { return NumTraits<T>::dummy_precision(); }
  static Real highest() { return (std::numeric_limits<T>::max)(); }
  static Real lowest() { return std::numeric_limits<T>::lowest(); }
  static Real infinity() { return std::numeric_limits<T>::infinity(); }
  static Real quiet_NaN() { return std::numeric_limits<T>::quiet_NaN(); }
};
// Doxygen loses the scope of this specialisation
/// @cond
/// With value = 0 a fixed-size Eigen array of Batch gets the alignment of Batch itself. Eigen's default can
/// be smaller, which clang++ rejects.
template <class T, int N, int size>
requires(size != Dynamic) struct internal::compute_default_alignment<trivium::Batch<T, N>, size> {
  enum { value = 0 };
};
/// @endcond
}  // namespace Eigen

namespace trivium {

/// The values of one lane (from 0) of a vector or matrix of batches.
template <class T, int N, int rows, int columns>
Eigen::Matrix<T, rows, columns> lane_of(const Eigen::Matrix<Batch<T, N>, rows, columns>& all, int lane) {
  return all.unaryExpr([lane](const Batch<T, N>& x) { return x[lane]; });
}

}  // namespace trivium
