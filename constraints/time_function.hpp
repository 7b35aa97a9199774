#pragma once
/// f(t), f' and f'' exactly: the functions of time that a scene may prescribe (scene format, "Functions of
/// time").

#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace trivium {

/// A value with its first and second time derivative.
template <class Scalar>
struct Jet {
  Scalar f{0}, f_t{0}, f_tt{0};

  friend Jet operator+(const Jet& a, const Jet& b) { return {a.f + b.f, a.f_t + b.f_t, a.f_tt + b.f_tt}; }
  friend Jet operator*(const Jet& a, const Jet& b) {
    return {a.f * b.f, a.f_t * b.f + a.f * b.f_t, a.f_tt * b.f + 2 * a.f_t * b.f_t + a.f * b.f_tt};
  }
};

/// sin(g(t)) by the chain rule.
template <class Scalar>
Jet<Scalar> sin(const Jet<Scalar>& g) {
  using std::cos, std::sin;
  const Scalar s = sin(g.f), c = cos(g.f);
  return {s, c * g.f_t, c * g.f_tt - s * g.f_t * g.f_t};
}

/// cos(g(t)) by the chain rule.
template <class Scalar>
Jet<Scalar> cos(const Jet<Scalar>& g) {
  using std::cos, std::sin;
  const Scalar s = sin(g.f), c = cos(g.f);
  return {c, -s * g.f_t, -s * g.f_tt - c * g.f_t * g.f_t};
}

/// A function of time as a scene states it: a tree of plain doubles, evaluated in any Scalar.
class TimeFunction {
 public:
  struct Polynomial {
    std::vector<double> coefficients;  ///< c0 + c1 t + c2 t^2 + ...
    bool operator==(const Polynomial&) const = default;
  };
  struct Harmonic {  ///< offset + amplitude sin(angular_frequency t + phase)
    double offset = 0, amplitude = 0, angular_frequency = 0, phase = 0;
    bool operator==(const Harmonic&) const = default;
  };
  struct Sin {
    std::vector<TimeFunction> of;  ///< exactly one
    bool operator==(const Sin&) const = default;
  };
  struct Cos {
    std::vector<TimeFunction> of;  ///< exactly one
    bool operator==(const Cos&) const = default;
  };
  struct Sum {
    std::vector<TimeFunction> terms;
    bool operator==(const Sum&) const = default;
  };
  struct Product {
    std::vector<TimeFunction> factors;
    bool operator==(const Product&) const = default;
  };
  struct Step5 {  ///< the quintic from (t0, f0) to (t1, f1), constant outside, twice continuously
                  ///< differentiable
    double t0 = 0, f0 = 0, t1 = 1, f1 = 0;
    bool operator==(const Step5&) const = default;
  };
  using Kind = std::variant<double, Polynomial, Harmonic, Sin, Cos, Sum, Product, Step5>;

  TimeFunction(double constant = 0) : kind_(constant) {}  // NOLINT: a number is a function of time
  template <class K>
  requires(!std::is_arithmetic_v<std::decay_t<K>> && std::is_constructible_v<Kind, K>) TimeFunction(K kind)
      : kind_(std::move(kind)) {}  // NOLINT

  const Kind& kind() const { return kind_; }
  bool operator==(const TimeFunction&) const = default;

  /// A plain number: its derivatives are known to be zero and need not be computed.
  bool is_number() const { return std::holds_alternative<double>(kind_); }

  /// f, f' and f'' at time t.
  template <class Scalar>
  Jet<Scalar> operator()(const Scalar& t) const {
    return std::visit([&](const auto& kind) { return evaluate(kind, t); }, kind_);
  }

 private:
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
  template <class Scalar>
  static Jet<Scalar> evaluate(const Harmonic& k, const Scalar& t) {
    const Jet<Scalar> phase{Scalar(k.angular_frequency) * t + Scalar(k.phase), Scalar(k.angular_frequency)};
    return Jet<Scalar>{Scalar(k.offset)} + Jet<Scalar>{Scalar(k.amplitude)} * sin(phase);
  }
  template <class Scalar>
  static Jet<Scalar> evaluate(const Sin& k, const Scalar& t) {
    return sin(k.of.front()(t));
  }
  template <class Scalar>
  static Jet<Scalar> evaluate(const Cos& k, const Scalar& t) {
    return cos(k.of.front()(t));
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

  Kind kind_;
};

}  // namespace trivium
