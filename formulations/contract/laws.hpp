#pragma once
/// Tests of a formulation, for authors of a new one: the laws that the functions of its three parts must
/// satisfy and that types cannot express. `broken_laws<F>()` evaluates the laws of every part that F has, at
/// fixed states of one body, and returns the laws that do not hold. The printed equations are compared with
/// the Newton-Euler equations in the body frame.

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "base/broken_law.hpp"
#include "bodies/rotations/so3.hpp"
#include "formulations/formulation.hpp"
#include "formulations/r_omega.hpp"

namespace trivium {

namespace detail {

/// Evaluates the laws of F and lists those that do not hold.
template <EquationsAsPrinted F>
class FormulationLaws {
 public:
  std::vector<BrokenLaw> broken() {
    for (int n = 0; n < 20; ++n) {
      try {
        at_sample(n);
      } catch (const std::exception& error) {
        broken_.push_back(
            {fmt::format("{}: throws at a pose rotated by {:.2f} full turns: {}", F::name,
                         std::acos(std::abs(static_cast<double>(pose(n)[0]))) / pi, error.what()),
             1, 0});
      }
    }
    return broken_;
  }

 private:
  using S = typename F::Scalar;
  using V = Vector3<S>;
  using Kinematics = typename F::Kinematics;
  using Unknown = typename F::Unknown;
  using Coordinates = typename F::Coordinates;

  /// A test state of one body: pose, angular velocity [rad/s, body frame], chart and coordinates.
  struct Sample {
    Vector4<S> p;
    V omega_bar;
    typename F::Chart chart;
    typename F::Coordinates q;
    Kinematics body;
  };

  /// A reproducible vector without symmetry; its components lie between -1 and 1.
  static V numbers(int seed) {
    const auto at = [seed](int k) { return S(std::sin(1.7 * (7 * k + 13 * seed + 1))); };
    return {at(0), at(1), at(2)};
  }
  /// Reports a law if a and b differ by more than digits_lost machine epsilons, relative to 1 + |a| + |b|.
  /// The margin 1e5 is far above the rounding of right formulas and far below the error of wrong ones.
  template <class A, class B>
  void equal(const char* law, const A& a, const B& b, double digits_lost = 1e5) {
    const double size = 1 + static_cast<double>(S(a.norm())) + static_cast<double>(S(b.norm()));
    const double off = static_cast<double>(S((a - b).norm())) / size;
    const double bound = digits_lost * static_cast<double>(std::numeric_limits<S>::epsilon());
    if (!(off <= bound)) broken_.push_back({std::string(F::name) + ": " + law, off, bound});
  }

  static constexpr double pi = 3.14159265358979323846;

  /// A pose rotated by at most 120 degrees (|e0| is at least half of the norm), so that coordinates that are
  /// singular at 180 degrees can be tested.
  static Vector4<S> pose(int n) {
    Vector4<S> p;
    p << S(1 + 0.01 * n), numbers(3 * n + 1);
    return (n % 2 == 0 ? 1 : -1) * p / p.norm();  // p and -p are the same rotation
  }
  static Sample sample(int n) {
    Sample s;
    s.p = pose(n);
    s.omega_bar = 2 * numbers(3 * n + 2);
    s.chart = F::choose_chart({}, s.p);
    s.q = F::from_pose(s.chart, s.p, s.omega_bar);
    s.body = F::kinematics(s.chart, numbers(n), numbers(n + 1), s.q);
    return s;
  }

  void at_sample(int n) {
    const Sample s = sample(n);
    poses(s, n);
    const Unknown q_ddot = accelerations(s, n);
    newton_and_euler(s, q_ddot, n);
    if constexpr (ReducedEquations<F>) reduced(s, n);
    if constexpr (MovingCoordinates<F>) moving(s, n);
  }

  void poses(const Sample& s, int n) {
    equal("kinematics returns the given position r", V(s.body.r), numbers(n));
    equal("kinematics returns the given velocity r'", V(s.body.r_dot), numbers(n + 1));
    const double distance = static_cast<double>(S(F::chart_distance(s.chart, s.q)));
    if (!(distance > 0 && distance <= 1))
      broken_.push_back(
          {std::string(F::name) + ": chart_distance is above 0 and at most 1 away from singularities",
           distance, 1});
    equal("kinematics of from_pose has the rotation A of the pose", s.body.A, rotation_matrix(s.p));
    equal("kinematics of from_pose has the given angular velocity", s.body.omega_bar, s.omega_bar);
    const Vector4<S> p = F::to_euler_parameters(s.chart, s.q);
    equal("to_euler_parameters recovers the pose", rotation_matrix(Vector4<S>(p / p.norm())),
          rotation_matrix(s.p));
  }
  /// Compares a'' of body vectors from the derivatives of the rotation with a'' from the Jacobian and bias
  /// of F. Returns a q'' that satisfies the internal rows.
  Unknown accelerations(const Sample& s, int n) {
    const Matrix<S, F::rotational_unknowns, 3> lift = F::lift(s.body);
    Unknown q_0 = Unknown::Zero();
    if constexpr (F::internal_constraints > 0) {
      const Matrix<S, F::internal_constraints, F::rotational_unknowns> P = F::internal_jacobian(s.body);
      const Matrix<S, F::internal_constraints, 3> turned = P * lift;
      equal("lift satisfies the internal rows: P lift = 0", turned, (turned * S(0)).eval());
      q_0 = P.transpose() * (P * P.transpose()).inverse() * F::internal_gamma(s.body);
    }
    const V x = numbers(n + 40);
    const Unknown q_ddot = lift * x + q_0;
    const V omega_bar_dot = F::to_angular_acceleration(s.body, q_ddot);
    equal("lift is the derivative of the unknown with respect to omega_bar'",
          V(omega_bar_dot - F::to_angular_acceleration(s.body, q_0)), x);
    for (int k = 0; k < 3; ++k) {
      const V a_bar = V::Unit(k) + numbers(n + k) / 2;
      const BodyVector<S> a = s.body.vector(a_bar);
      equal("a body vector in the global frame is A a_bar", a.a, V(s.body.A * a_bar));
      equal("the rate of a body vector is A (omega_bar x a_bar)", a.rate,
            V(s.body.A * s.omega_bar.cross(a_bar)));
      const Matrix<S, 3, F::rotational_unknowns> J = s.body.jacobian(a);
      equal("Jacobian and bias give the second derivative of a body vector", V(J * q_ddot + a.bias),
            V(s.body.A * (omega_bar_dot.cross(a_bar) + s.omega_bar.cross(s.omega_bar.cross(a_bar)))));
      const V w = numbers(n + 50 + k);
      const Matrix<S, 1, F::rotational_unknowns> along = s.body.jacobian_along(a, w);
      equal("jacobian_along is w^T times the Jacobian", along, (w.transpose() * J).eval());
    }
    return q_ddot;
  }
  static Matrix3<S> inertia(int n) {
    const V d = numbers(n + 60).cwiseAbs();
    const Matrix3<S> turned = rotation_matrix(sample(n + 1).p);
    return turned * V(1 + d[0], 1 + d[1], 1 + d[2]).asDiagonal() * turned.transpose();
  }
  void newton_and_euler(const Sample& s, const Unknown& q_ddot, int n) {
    const Matrix3<S> J_bar = inertia(n);
    const Matrix<S, F::rotational_unknowns, 3> lift = F::lift(s.body);
    const V omega_bar_dot = F::to_angular_acceleration(s.body, q_ddot);
    const V n_bar = J_bar * omega_bar_dot + s.omega_bar.cross(J_bar * s.omega_bar), load = numbers(n + 70);
    const Unknown applied = F::applied_force(s.body, load), held = F::applied_force(s.body, n_bar);
    equal("lift^T applied_force is the applied moment", V(lift.transpose() * applied), load);
    const Unknown left = F::mass_block(s.body, J_bar) * q_ddot - F::velocity_force(s.body, J_bar) - held;
    equal("lift^T times the printed equations gives Euler's equations", V(lift.transpose() * left),
          V(V::Zero()));
    if constexpr (F::internal_constraints == 0)
      equal("without internal rows the printed equations are equivalent to Euler's equations", left,
            (left * S(0)).eval());
  }

  void reduced(const Sample& s, int n) {
    const typename F::Reduced body{s.body};
    const Matrix3<S> J_bar = inertia(n);
    const V x = numbers(n + 80), load = numbers(n + 81);
    const Unknown q_ddot = F::from_reduced(s.body, x), at_0 = F::from_reduced(s.body, V(V::Zero()));
    if constexpr (F::internal_constraints > 0)
      equal("from_reduced satisfies the internal rows", (F::internal_jacobian(s.body) * q_ddot).eval(),
            F::internal_gamma(s.body));
    equal("increment is the change of the unknown with the reduced unknown", Unknown(q_ddot - at_0),
          Unknown(F::increment(s.body, x)));
    equal("omega_bar_dot_from_reduced is the angular acceleration of the unknown",
          V(F::omega_bar_dot_from_reduced(s.body, x)), V(F::to_angular_acceleration(s.body, q_ddot)));
    const Unknown inertia_force = F::mass_block(s.body, J_bar) * F::increment(s.body, x);
    equal("reduced_mass_block is the reduction of mass_block", V(F::reduced(body, inertia_force)),
          V(F::reduced_mass_block(s.body, J_bar) * x));
    const Unknown force = F::applied_force(s.body, load) + F::velocity_force(s.body, J_bar) -
                          F::mass_block(s.body, J_bar) * at_0;
    equal("reduced_force is the reduction of the printed forces", V(F::reduced(body, force)),
          V(F::reduced_force(s.body, J_bar, load)));
    equal("moment recovers the applied moment from its reduced force",
          V(F::moment(body, F::reduced(body, Unknown(F::applied_force(s.body, load))))), load);
    const V a_bar = numbers(n + 82), bias = body.vector(a_bar).bias + body.jacobian(body.vector(a_bar)) * x;
    const BodyVector<S> printed = s.body.vector(a_bar);
    equal("reduced and printed unknowns give the same second derivative of a body vector", bias,
          V(printed.bias + s.body.jacobian(printed) * q_ddot));
    const AngularMotion<S> turn = F::angular_motion(body);
    const V omega = turn.omega.template head<3>(),
            alpha = turn.axes_T.template topRows<3>().transpose() * x + turn.drift.template head<3>();
    const V a = turn.A.template topRows<3>() * a_bar;
    equal("angular_motion gives body vectors", a, printed.a);
    equal("angular_motion gives the rates of body vectors", V(omega.cross(a)), printed.rate);
    equal("angular_motion gives the second derivatives of body vectors",
          V(alpha.cross(a) + omega.cross(omega.cross(a))), bias);
    if (F::reduced_mass_is_constant)
      equal("reduced_mass_is_constant: reduced_mass_block is the same in another state",
            F::reduced_mass_block(s.body, J_bar), F::reduced_mass_block(sample(n + 1).body, J_bar));
  }

  void moving(const Sample& s, int n) {
    const typename F::Orientation at = F::orientation_of(s.chart, s.p);
    const Unknown v = F::velocity_of(s.chart, s.q);
    const auto again =
        F::kinematics(s.chart, V(V::Zero()), V(V::Zero()), F::from_orientation(s.chart, at, v));
    equal("from_orientation recovers the rotation", again.A, s.body.A);
    equal("from_orientation recovers the angular velocity", again.omega_bar, s.omega_bar);
    Unknown by = v;
    for (Eigen::Index k = 0; k < by.size(); ++k)
      by[k] = S(0.05 * std::sin(1.0 + 3.0 * static_cast<double>(k) + n));
    const typename F::Orientation there = F::step(s.chart, at, by);
    equal("displacement recovers the increment of step", Unknown(F::displacement(s.chart, at, there)), by);
    equal("displacement_rate at displacement 0 is the velocity",
          Unknown(F::displacement_rate(Unknown(Unknown::Zero()), v)), v);
    normalised(s, at, v, by, n);
    if (F::inertia_is_constant) {
      const Matrix3<S> J_bar = inertia(n);
      equal("inertia_is_constant: mass_block is the same in another state", F::mass_block(s.body, J_bar),
            F::mass_block(sample(n + 1).body, J_bar));
    }
    paths(s, at, v, there, by);
    typename F::Orientation same = F::retract(s.chart, at, by);
    const typename F::Orientation retracted_there = same;
    Unknown any = v;
    F::normalise(same, any);
    equal("retract satisfies the internal rows", same, retracted_there);
  }

  /// Central differences with the step h = epsilon^(1/3), where epsilon is the machine epsilon, the local
  /// `u`: there truncation and rounding errors balance, both near epsilon^(2/3). The bound is 1000 times as
  /// large, far below the error of wrong formulas. The first two laws compare rotations, not coordinates,
  /// because an angle may jump by 2 pi between the two points.
  template <class Orientation>
  void paths(const Sample& s, const Orientation& at, const Unknown& v, const Orientation& there,
             const Unknown& by) {
    using std::cbrt;
    const double u = static_cast<double>(std::numeric_limits<S>::epsilon()), digits_lost = 1e3 / cbrt(u);
    const S h(cbrt(u));
    const auto rotation = [&](const Orientation& x) {
      const Coordinates q = F::from_orientation(s.chart, x, v);
      return Matrix3<S>(F::kinematics(s.chart, V(V::Zero()), V(V::Zero()), q).A);
    };
    const Matrix3<S> turns = s.body.A * tilde(s.omega_bar);
    const Orientation rate = F::orientation_rate(s.chart, at, v);
    equal("orientation_rate gives the rate of the rotation, A tilde(omega_bar)",
          Matrix3<S>((rotation(at + h * rate) - rotation(at - h * rate)) / (2 * h)), turns, digits_lost);
    equal("retract has the derivative orientation_rate at increment 0",
          Matrix3<S>((rotation(F::retract(s.chart, at, Unknown(h * v))) -
                      rotation(F::retract(s.chart, at, Unknown(-h * v)))) /
                     (2 * h)),
          turns, digits_lost);
    const Orientation on = F::orientation_rate(s.chart, there, v);
    equal("displacement_rate is the time derivative of displacement",
          Unknown(
              (F::displacement(s.chart, at, there + h * on) - F::displacement(s.chart, at, there - h * on)) /
              (2 * h)),
          Unknown(F::displacement_rate(by, v)), digits_lost);
  }

  /// Normalisation: the return onto the internal rows from a displacement off them.
  template <class Orientation>
  void normalised(const Sample& s, const Orientation& at, const Unknown& v, const Unknown& by, int n) {
    const auto meets = [&](const char* law, const Orientation& x, const Unknown& v_x) {
      Orientation same = x;
      Unknown v_same = v_x;
      F::normalise(same, v_same);
      equal(law, same, x);
      equal(law, v_same, v_x);
      if constexpr (F::internal_constraints > 0) {
        const auto body =
            F::kinematics(s.chart, V(V::Zero()), V(V::Zero()), F::from_orientation(s.chart, x, v_x));
        const auto rate = (F::internal_jacobian(body) * v_x).eval();
        equal(law, rate, (rate * S(0)).eval());
      }
    };
    meets("normalise does not change a state that satisfies the internal rows", at, v);
    const Orientation off = F::step(s.chart, at, by);
    const Unknown v_off = v + by;
    Orientation there = off;
    Unknown v_there = v_off;
    F::normalise(there, v_there);
    meets("normalise: the state satisfies the internal rows", there, v_there);

    const S share(0.3 + 0.01 * n);
    const Unknown none = Unknown::Zero();
    there = off;
    Unknown change = none;
    F::normalise_step(there, share, change);
    equal("normalise_step moves the orientation by share times the change of the unknown",
          Unknown(F::displacement(s.chart, off, there)), Unknown(share * change));
    v_there = v;
    Orientation same = there;
    F::normalise(same, v_there);
    equal("normalise_step: the orientation satisfies the internal rows", same, there);
    change = none;
    F::normalise_step_velocity(at, v_off, share, change);
    meets("normalise_step_velocity: the velocity satisfies the internal rows", at,
          Unknown(v_off + share * change));
  }

  std::vector<BrokenLaw> broken_;
};

}  // namespace detail

/// The laws that the formulation F breaks, each with its measured error; empty if none. Laws of the reduced
/// equations and of the moving coordinates are tested if F has these parts.
template <EquationsAsPrinted F>
std::vector<BrokenLaw> broken_laws() {
  return detail::FormulationLaws<F>().broken();
}

}  // namespace trivium
