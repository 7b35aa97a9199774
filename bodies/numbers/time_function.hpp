#pragma once
/// The functions of time f(t) that a scene may prescribe (scenes/format/scene.schema.json), with their
/// analytic derivatives f' and f''. A driving constraint needs f in Phi, f' in nu and f'' in gamma;
/// difference quotients would lose half of the digits.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace trivium {

/// A value f with its first and second time derivative; + and * follow the sum and product rule.
template <class Scalar>
struct Jet {
  Scalar f{0}, f_t{0}, f_tt{0};

  friend Jet operator+(const Jet& a, const Jet& b) { return {a.f + b.f, a.f_t + b.f_t, a.f_tt + b.f_tt}; }
  friend Jet operator*(const Jet& a, const Jet& b) {
    return {a.f * b.f, a.f_t * b.f + a.f * b.f_t, a.f_tt * b.f + 2 * a.f_t * b.f_t + a.f * b.f_tt};
  }
};

/// An angle g + rest [rad], the argument of a sine or cosine. After many revolutions g is large, and without
/// `rest` its rounding error, |g| u, would become an error of the same size in sin(g).
template <class Scalar>
struct Phase {
  Jet<Scalar> g;   ///< the rounded angle with its time derivatives
  Scalar rest{0};  ///< correction of g.f for its rounding error [rad], where known

  /// sum + rest = x y + constant, with `sum` the rounded value. The error of the rounded product p is
  /// fma(x, y, -p), that of the sum follows from Knuth's two-sum. `rest` is 0 unless Scalar is float, double
  /// or long double.
  static void add_product(const Scalar& x, const Scalar& y, const Scalar& constant, Scalar& sum,
                          Scalar& rest) {
    const Scalar product = x * y;
    sum = product + constant;
    rest = Scalar(0);
    if constexpr (std::is_floating_point_v<Scalar>) {
      const Scalar back = sum - product;
      rest = std::fma(x, y, -product) + ((product - (sum - back)) + (constant - back));
    }
  }
};

/// The sine and cosine of a phase with their first and second time derivatives, by the chain rule.
template <class Scalar>
struct SineCosine {
  Jet<Scalar> sine, cosine;

  explicit SineCosine(const Phase<Scalar>& phase) {
    using std::abs, std::cos, std::sin;
    const Jet<Scalar>& g = phase.g;
    // addition theorem for g + r with |r| of size |g| u, as a rule small: then sin r = r - r^3/6 and 1 - cos
    // r = r^2/2 to rounding
    const Scalar s_0 = sin(g.f), c_0 = cos(g.f), r = phase.rest;
    const bool is_small = abs(r) < Scalar(1e-4);
    const Scalar r_cos = is_small ? Scalar(r * r / 2) : Scalar(1 - cos(r)),
                 r_sin = is_small ? Scalar(r - r * r_cos / 3) : Scalar(sin(r));
    const Scalar s = s_0 + (r_sin * c_0 - r_cos * s_0), c = c_0 - (r_sin * s_0 + r_cos * c_0);
    sine = {s, c * g.f_t, c * g.f_tt - s * g.f_t * g.f_t};
    cosine = {c, -s * g.f_t, -s * g.f_tt - c * g.f_t * g.f_t};
  }
};

/// A function of time as a scene defines it: a tree with double coefficients that can be evaluated in any
/// Scalar. Angles are in rad and times in s; the unit of f depends on its use.
class TimeFunction {
 public:
  /// c0 + c1 t + c2 t^2 + ...
  struct Polynomial {
    std::vector<double> coefficients;  ///< c0, c1, c2, ...
    bool operator==(const Polynomial&) const = default;
  };
  /// offset + amplitude sin(angular_frequency t + phase).
  struct Harmonic {
    double offset = 0, amplitude = 0, angular_frequency = 0, phase = 0;
    bool operator==(const Harmonic&) const = default;
  };
  /// Sine of a function of time.
  struct Sin {
    std::vector<TimeFunction> of;  ///< the argument [rad], exactly one; a vector since the type is recursive
    bool operator==(const Sin&) const = default;
  };
  /// Cosine of a function of time.
  struct Cos {
    std::vector<TimeFunction> of;  ///< the argument [rad], exactly one
    bool operator==(const Cos&) const = default;
  };
  /// Sum of functions of time.
  struct Sum {
    std::vector<TimeFunction> terms;
    bool operator==(const Sum&) const = default;
  };
  /// Product of functions of time.
  struct Product {
    std::vector<TimeFunction> factors;
    bool operator==(const Product&) const = default;
  };
  /// Smooth step by a quintic polynomial: f0 up to t0, f1 from t1 on; f' and f'' are continuous.
  struct Step5 {
    double t0 = 0, f0 = 0, t1 = 1, f1 = 0;
    bool operator==(const Step5&) const = default;
  };
  /// pieces[0] for t < times[0], pieces[k] for times[k - 1] <= t < times[k]. f, f' and f'' may jump at these
  /// times; the value at the time itself is that of the later piece.
  struct Piecewise {
    std::vector<double> times;         ///< ascending [s]
    std::vector<TimeFunction> pieces;  ///< functions of t, one more than `times`
    bool operator==(const Piecewise&) const = default;
  };
  using Kind = std::variant<double, Polynomial, Harmonic, Sin, Cos, Sum, Product, Step5, Piecewise>;

  TimeFunction(double constant = 0) : kind_(constant) {}  // NOLINT: implicit, a number is a constant function
  template <class K>
  requires(!std::is_arithmetic_v<std::decay_t<K>> && std::is_constructible_v<Kind, K>) TimeFunction(K kind)
      : kind_(std::move(kind)) {}  // NOLINT

  const Kind& kind() const { return kind_; }
  bool operator==(const TimeFunction&) const = default;

  /// Whether the function is given as a plain number, so that its derivatives are zero.
  bool is_number() const { return std::holds_alternative<double>(kind_); }

  /// Whether f is recognised as constant from its coefficients; sin^2 + cos^2 is not.
  bool is_constant() const {
    return std::visit([](const auto& kind) { return constant(kind); }, kind_);
  }
  /// Appends the times where f'' has a kink or where f, f' or f'' jumps. An integration method keeps its
  /// order if its steps end at these times.
  void append_kinks(std::vector<double>& times) const {
    std::visit([&](const auto& kind) { add_kinks(kind, times); }, kind_);
  }

  /// f, f' and f'' at time t.
  template <class Scalar>
  Jet<Scalar> operator()(const Scalar& t) const {
    return std::visit([&](const auto& kind) { return evaluate(kind, t); }, kind_);
  }
  /// f, f' and f'' at time t, with the rounding error of f in `rest` if the function is a polynomial.
  template <class Scalar>
  Phase<Scalar> phase(const Scalar& t) const {
    if (const auto* polynomial = std::get_if<Polynomial>(&kind_)) return polynomial_phase(*polynomial, t);
    return {(*this)(t)};
  }

 private:
  static bool all_constant(const std::vector<TimeFunction>& parts) {
    return std::all_of(parts.begin(), parts.end(), [](const TimeFunction& f) { return f.is_constant(); });
  }
  static bool constant(double) { return true; }
  static bool constant(const Polynomial& k) {
    return std::all_of(k.coefficients.begin() + std::min<std::ptrdiff_t>(1, std::ssize(k.coefficients)),
                       k.coefficients.end(), [](double c) { return c == 0; });
  }
  static bool constant(const Harmonic& k) { return k.amplitude == 0 || k.angular_frequency == 0; }
  static bool constant(const Sin& k) { return all_constant(k.of); }
  static bool constant(const Cos& k) { return all_constant(k.of); }
  static bool constant(const Sum& k) { return all_constant(k.terms); }
  static bool constant(const Product& k) { return all_constant(k.factors); }
  static bool constant(const Step5& k) { return k.f0 == k.f1; }
  static bool constant(const Piecewise& k) {
    return all_constant(k.pieces) && std::all_of(k.pieces.begin(), k.pieces.end(), [&](const auto& piece) {
             return piece(0.0).f == k.pieces.front()(0.0).f;
           });
  }

  static void add_all_kinks(const std::vector<TimeFunction>& parts, std::vector<double>& times) {
    for (const TimeFunction& f : parts) f.append_kinks(times);
  }
  template <class K>
  static void add_kinks(const K&, std::vector<double>&) {}
  static void add_kinks(const Sin& k, std::vector<double>& times) { add_all_kinks(k.of, times); }
  static void add_kinks(const Cos& k, std::vector<double>& times) { add_all_kinks(k.of, times); }
  static void add_kinks(const Sum& k, std::vector<double>& times) { add_all_kinks(k.terms, times); }
  static void add_kinks(const Product& k, std::vector<double>& times) { add_all_kinks(k.factors, times); }
  static void add_kinks(const Step5& k, std::vector<double>& times) {
    times.insert(times.end(), {k.t0, k.t1});
  }
  static void add_kinks(const Piecewise& k, std::vector<double>& times) {
    times.insert(times.end(), k.times.begin(), k.times.end());
    add_all_kinks(k.pieces, times);
  }

  template <class Scalar>
  static Jet<Scalar> evaluate(double constant, const Scalar&) {
    return {Scalar(constant)};
  }
  template <class Scalar>
  static Jet<Scalar> evaluate(const Polynomial& k, const Scalar& t) {  // Horner, differentiated twice
    Jet<Scalar> y;
    for (auto c = k.coefficients.rbegin(); c != k.coefficients.rend(); ++c)
      y = {y.f * t + Scalar(*c), y.f_t * t + y.f, y.f_tt * t + 2 * y.f_t};
    return y;
  }
  /// Compensated Horner scheme: the rounding error of every step is propagated in `rest`.
  template <class Scalar>
  static Phase<Scalar> polynomial_phase(const Polynomial& k, const Scalar& t) {
    Phase<Scalar> phase{evaluate(k, t)};
    Scalar sum(0);
    for (auto c = k.coefficients.rbegin(); c != k.coefficients.rend(); ++c) {
      Scalar next, rest;
      Phase<Scalar>::add_product(sum, t, Scalar(*c), next, rest);
      phase.rest = phase.rest * t + rest;
      sum = next;
    }
    phase.g.f = sum;
    return phase;
  }
  template <class Scalar>
  static Jet<Scalar> evaluate(const Harmonic& k, const Scalar& t) {
    Phase<Scalar> phase{{Scalar(0), Scalar(k.angular_frequency)}};
    Phase<Scalar>::add_product(Scalar(k.angular_frequency), t, Scalar(k.phase), phase.g.f, phase.rest);
    return Jet<Scalar>{Scalar(k.offset)} + Jet<Scalar>{Scalar(k.amplitude)} * SineCosine<Scalar>(phase).sine;
  }
  template <class Scalar>
  static Jet<Scalar> evaluate(const Sin& k, const Scalar& t) {
    return SineCosine<Scalar>(k.of.front().phase(t)).sine;
  }
  template <class Scalar>
  static Jet<Scalar> evaluate(const Cos& k, const Scalar& t) {
    return SineCosine<Scalar>(k.of.front().phase(t)).cosine;
  }
  template <class Scalar>
  static Jet<Scalar> evaluate(const Sum& k, const Scalar& t) {
    Jet<Scalar> y;
    for (const TimeFunction& term : k.terms) y = y + term(t);
    return y;
  }
  template <class Scalar>
  static Jet<Scalar> evaluate(const Product& k, const Scalar& t) {
    Jet<Scalar> y{Scalar(1)};
    for (const TimeFunction& factor : k.factors) y = y * factor(t);
    return y;
  }
  template <class Scalar>
  static Jet<Scalar> evaluate(const Step5& k, const Scalar& t) {
    if (t <= Scalar(k.t0)) return {Scalar(k.f0)};
    if (t >= Scalar(k.t1)) return {Scalar(k.f1)};
    const Scalar T = Scalar(k.t1) - Scalar(k.t0), x = (t - Scalar(k.t0)) / T,
                 rise = Scalar(k.f1) - Scalar(k.f0);
    return {Scalar(k.f0) + rise * x * x * x * (10 + x * (6 * x - 15)),
            rise * 30 * x * x * (1 - x) * (1 - x) / T, rise * 60 * x * (1 - x) * (1 - 2 * x) / (T * T)};
  }
  template <class Scalar>
  static Jet<Scalar> evaluate(const Piecewise& k, const Scalar& t) {
    const auto later =
        std::find_if(k.times.begin(), k.times.end(), [&](double at) { return t < Scalar(at); });
    return k.pieces[later - k.times.begin()](t);
  }

  Kind kind_;
};

}  // namespace trivium
