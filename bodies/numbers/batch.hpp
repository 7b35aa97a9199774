#pragma once
/// A Scalar that carries N numbers at once, each its own state: the same code then walks N states of one
/// scene in lockstep, on the processor's vector units. Every operation is that of each number alone, so
/// results are those of the numbers one by one, up to how the compiler fuses a multiplication with an
/// addition.

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "bodies/numbers/compiled_with.hpp"
#include "bodies/numbers/lanewise.hpp"

namespace trivium {

/// As many numbers as a vector register of this build holds.
template <class T>
inline constexpr int native_lanes =
#if defined(__AVX512F__)
    64 / sizeof(T);
#elif defined(__AVX__)
    32 / sizeof(T);
#else
    16 / sizeof(T);
#endif

template <class T, int N>
class Batch {
 public:
  static constexpr int lanes = N;
  using Lanes [[gnu::vector_size(sizeof(T) * N)]] = T;

  /// What a comparison says of every lane. As a condition it must be the same for all.
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
    operator bool() const {  // NOLINT: an if over numbers stays an if over batches
      if (all()) return true;
      if (any()) throw MixedLanes();
      return false;
    }

   private:
    Bits bits_;
  };

  Batch() = default;
  template <class Number>
  requires std::is_arithmetic_v<Number> Batch(Number value) {  // NOLINT: a number is the same in all lanes
    for (int k = 0; k < N; ++k) lanes_[k] = static_cast<T>(value);
  }

  T operator[](int lane) const { return lanes_[lane]; }
  void set(int lane, T value) { lanes_[lane] = value; }
  /// The first lane, for messages.
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
  /// The least of all lanes, in all lanes.
  friend T least_lane(const Batch& x) {
    T least = x[0];
    for (int k = 1; k < N; ++k) least = x[k] < least ? x[k] : least;
    return least;
  }

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
/// Arrays keep the alignment of their lanes: Eigen would ask for less, which clang++ refuses.
template <class T, int N, int size>
requires(size != Dynamic) struct internal::compute_default_alignment<trivium::Batch<T, N>, size> {
  enum { value = 0 };
};
/// @endcond
}  // namespace Eigen

namespace trivium {

/// One lane of a vector or a matrix.
template <class T, int N, int rows, int columns>
Eigen::Matrix<T, rows, columns> lane_of(const Eigen::Matrix<Batch<T, N>, rows, columns>& all, int lane) {
  return all.unaryExpr([lane](const Batch<T, N>& x) { return x[lane]; });
}

}  // namespace trivium
