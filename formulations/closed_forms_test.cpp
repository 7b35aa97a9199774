/// gamma in the closed forms of the textbooks, and identities between the rows of different formulations.

#include "bodies/numbers/quad.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "constraints/constraint_row.hpp"
#include "formulations/testing/moving_body.hpp"

namespace trivium {
namespace {

using test::distance, test::Random, test::roundings;
using S = Quad;
using Vec = Vector3<S>;

/// Two bodies, and all parameters of the basic constraints between them.
struct Pair {
  Vec a_i, a_j, s_i, s_j, c;
  TimeFunction f = TimeFunction::Harmonic{0.3, 0.8, 1.7, 0.4};
  S t;
  Vector4<S> p_i, p_j;
  Vec r_i, r_j, v_i, v_j, w_i, w_j;
  ChartOptions options;

  template <class F>
  typename F::Kinematics body(const Vec& r, const Vec& v, const Vector4<S>& p, const Vec& w) const {
    const auto chart = F::choose_chart(options, p);
    return F::kinematics(chart, r, v, F::from_pose(chart, p, w));
  }
  template <class F>
  auto row(const BasicConstraint<S>& constraint) const {
    return evaluate_row(constraint, body<F>(r_i, v_i, p_i, w_i), body<F>(r_j, v_j, p_j, w_j), t);
  }
  DP1<S> dp1() const { return {{0, 1}, a_i, a_j, f}; }
  DP2<S> dp2() const { return {{0, 1}, a_i, s_i, s_j, f}; }
  D<S> d() const { return {{0, 1}, s_i, s_j, f}; }
  CD<S> cd() const { return {{0, 1}, c, s_i, s_j, f}; }
  TurningDP1<S> turning() const { return {{0, 1}, a_i, s_i, a_j, f}; }
};

Pair random_pair(Random& random, const ChartOptions& options = {}) {
  const auto v = [&] { return random.vector<S, 3>(); };
  Pair x;
  x.a_i = v(), x.a_j = v(), x.s_i = v(), x.s_j = v(), x.c = v();
  x.t = S(random.uniform());
  x.p_i = random.euler_parameters<S>(), x.p_j = random.euler_parameters<S>();
  x.r_i = v(), x.r_j = v(), x.v_i = v(), x.v_j = v(), x.w_i = v(), x.w_j = v();
  x.options = options;
  return x;
}

constexpr double bound = 1e-30;  // about 10000 unit roundoffs of quad (9.6e-35)
double error(const S& a, const S& b) { return std::abs(static_cast<double>(S(a - b))); }

// The lecture notes' gamma_hat (Negrut, ME751; Haug 1989, section 9.6), with B(p, a_bar) of r-p.
TEST(GammaInRP, IsTheLectureNotesClosedForm) {
  Random random(61);
  for (int n = 0; n < 200; ++n) {
    const Pair x = random_pair(random);
    const Vector4<S> p_i_dot = G_matrix(x.p_i).transpose() * x.w_i / 2;
    const Vector4<S> p_j_dot = G_matrix(x.p_j).transpose() * x.w_j / 2;
    const auto A_i = rotation_matrix(x.p_i), A_j = rotation_matrix(x.p_j);
    const auto quadratic = [](const Vector4<S>& p_dot, const Vec& s) {
      return Vec(RP<S>::B(p_dot, s) * p_dot);
    };
    const Vec a_i = A_i * x.a_i, a_j = A_j * x.a_j;
    const Vec a_i_dot = RP<S>::B(x.p_i, x.a_i) * p_i_dot, a_j_dot = RP<S>::B(x.p_j, x.a_j) * p_j_dot;
    const Vec d = x.r_j + A_j * x.s_j - x.r_i - A_i * x.s_i;
    const Vec d_dot = x.v_j + RP<S>::B(x.p_j, x.s_j) * p_j_dot - x.v_i - RP<S>::B(x.p_i, x.s_i) * p_i_dot;
    const S f_tt = x.f(x.t).f_tt;
    const auto gamma = [&](const BasicConstraint<S>& c) { return x.row<RP<S>>(c).gamma; };

    EXPECT_LE(error(gamma(x.dp1()), -a_i.dot(quadratic(p_j_dot, x.a_j)) - a_j.dot(quadratic(p_i_dot, x.a_i)) -
                                        2 * a_i_dot.dot(a_j_dot) + f_tt),
              bound);
    EXPECT_LE(error(gamma(x.dp2()), -a_i.dot(quadratic(p_j_dot, x.s_j)) + a_i.dot(quadratic(p_i_dot, x.s_i)) -
                                        d.dot(quadratic(p_i_dot, x.a_i)) - 2 * a_i_dot.dot(d_dot) + f_tt),
              bound);
    EXPECT_LE(error(gamma(x.d()), -2 * d.dot(quadratic(p_j_dot, x.s_j)) +
                                      2 * d.dot(quadratic(p_i_dot, x.s_i)) - 2 * d_dot.dot(d_dot) + f_tt),
              bound);
    EXPECT_LE(
        error(gamma(x.cd()), x.c.dot(quadratic(p_i_dot, x.s_i)) - x.c.dot(quadratic(p_j_dot, x.s_j)) + f_tt),
        bound);
  }
}

// The same closed forms in r-omega: A tilde(omega_bar) tilde(omega_bar) sbar replaces B(p', sbar) p'.
TEST(GammaInROmega, IsTheLectureNotesClosedForm) {
  Random random(62);
  for (int n = 0; n < 200; ++n) {
    const Pair x = random_pair(random);
    const auto A_i = rotation_matrix(x.p_i), A_j = rotation_matrix(x.p_j);
    const Matrix3<S> W_i = tilde(x.w_i), W_j = tilde(x.w_j);
    const Vec a_i = A_i * x.a_i, a_j = A_j * x.a_j;
    const Vec a_i_dot = A_i * W_i * x.a_i, a_j_dot = A_j * W_j * x.a_j;
    const Vec d = x.r_j + A_j * x.s_j - x.r_i - A_i * x.s_i;
    const Vec d_dot = x.v_j + A_j * W_j * x.s_j - x.v_i - A_i * W_i * x.s_i;
    const S f_tt = x.f(x.t).f_tt;
    const auto gamma = [&](const BasicConstraint<S>& c) { return x.row<ROmega<S>>(c).gamma; };

    EXPECT_LE(error(gamma(x.dp1()), -a_i.dot(A_j * W_j * W_j * x.a_j) - a_j.dot(A_i * W_i * W_i * x.a_i) -
                                        2 * a_i_dot.dot(a_j_dot) + f_tt),
              bound);
    EXPECT_LE(error(gamma(x.dp2()), -a_i.dot(A_j * W_j * W_j * x.s_j) + a_i.dot(A_i * W_i * W_i * x.s_i) -
                                        d.dot(A_i * W_i * W_i * x.a_i) - 2 * a_i_dot.dot(d_dot) + f_tt),
              bound);
    EXPECT_LE(error(gamma(x.d()), -2 * d.dot(A_j * W_j * W_j * x.s_j) + 2 * d.dot(A_i * W_i * W_i * x.s_i) -
                                      2 * d_dot.dot(d_dot) + f_tt),
              bound);
    EXPECT_LE(error(gamma(x.cd()), x.c.dot(A_i * W_i * W_i * x.s_i - A_j * W_j * W_j * x.s_j) + f_tt), bound);
  }
}

/// Applies a law to a row of every kind, over all charts.
template <class Law>
void for_all_rows(const Law& law) {
  Random random(63);
  test::for_all_charts([&](const ChartOptions& options) {
    const Pair x = random_pair(random, options);
    for (const BasicConstraint<S>& c :
         {BasicConstraint<S>(x.dp1()), BasicConstraint<S>(x.dp2()), BasicConstraint<S>(x.d()),
          BasicConstraint<S>(x.cd()), BasicConstraint<S>(x.turning())})
      law(x, c);
  });
}

TEST(Identities, BodyFrameJacobianIsHalfPhiPGTransposed) {
  for_all_rows([](const Pair& x, const BasicConstraint<S>& c) {
    const auto omega = x.row<ROmega<S>>(c);
    const auto p = x.row<RP<S>>(c);
    EXPECT_LE(distance(omega.rot_i, p.rot_i * G_matrix(x.p_i).transpose() / 2), bound);
    EXPECT_LE(distance(omega.rot_j, p.rot_j * G_matrix(x.p_j).transpose() / 2), bound);
    EXPECT_LE(distance(omega.r_i, p.r_i) + distance(omega.r_j, p.r_j), bound);
    EXPECT_LE(error(omega.phi, p.phi) + error(omega.nu, p.nu), bound);
  });
}

TEST(Identities, AnglesJacobianIsTheBodyFrameOneTimesD) {
  for_all_rows([](const Pair& x, const BasicConstraint<S>& c) {
    const auto omega = x.row<ROmega<S>>(c);
    const auto angles = x.row<REpsilon<S>>(c);
    const auto i = x.body<REpsilon<S>>(x.r_i, x.v_i, x.p_i, x.w_i);
    const auto j = x.body<REpsilon<S>>(x.r_j, x.v_j, x.p_j, x.w_j);
    EXPECT_LE(distance(angles.rot_i, omega.rot_i * i.D), bound);
    EXPECT_LE(distance(angles.rot_j, omega.rot_j * j.D), bound);
    EXPECT_LE(distance(omega.r_i, angles.r_i) + distance(omega.r_j, angles.r_j), bound);
    EXPECT_LE(error(omega.phi, angles.phi) + error(omega.nu, angles.nu), bound);
  });
}

TEST(Identities, GammaOfEulerParametersDiffersByTheirCentripetalTerm) {
  for_all_rows([](const Pair& x, const BasicConstraint<S>& c) {
    const auto omega = x.row<ROmega<S>>(c);
    const auto p = x.row<RP<S>>(c);
    const S expected =
        omega.gamma -
        (x.w_i.squaredNorm() * p.rot_i.dot(x.p_i) + x.w_j.squaredNorm() * p.rot_j.dot(x.p_j)) / 4;
    EXPECT_LE(error(p.gamma, expected), bound);
  });
}

TEST(Identities, GammaOfAnglesDiffersByDDotTerms) {
  for_all_rows([](const Pair& x, const BasicConstraint<S>& c) {
    const auto omega = x.row<ROmega<S>>(c);
    const auto i = x.body<REpsilon<S>>(x.r_i, x.v_i, x.p_i, x.w_i);
    const auto j = x.body<REpsilon<S>>(x.r_j, x.v_j, x.p_j, x.w_j);
    const S terms = omega.rot_i.dot(i.D_dot_rates) + omega.rot_j.dot(j.D_dot_rates);
    // charts without re-framing may be near their singularity, where D^-1 amplifies rounding by 1 / distance
    const auto rates_of = [](const auto& body) { return Vector3<S>(body.D.inverse() * body.omega_bar); };
    const double size =
        1 + rates_of(i).squaredNorm().convert_to<double>() + rates_of(j).squaredNorm().convert_to<double>();
    EXPECT_LE(error(x.row<REpsilon<S>>(c).gamma, omega.gamma - terms), bound * size);
  });
}

TEST(Identities, OmegaFirstHasTheRowsOfROmega) {
  for_all_rows([](const Pair& x, const BasicConstraint<S>& c) {
    const auto omega = x.row<ROmega<S>>(c);
    const auto first = x.row<REpsilonOmegaFirst<S>>(c);
    EXPECT_LE(distance(omega.rot_i, first.rot_i) + distance(omega.rot_j, first.rot_j), bound);
    EXPECT_LE(error(omega.gamma, first.gamma), bound);
  });
}

TEST(Identities, PDdotIsHalfGTransposedOmegaBarDotLessACentripetalTerm) {
  Random random(64);
  for (int n = 0; n < 100; ++n) {
    const Pair x = random_pair(random);
    const auto body = x.body<RP<S>>(x.r_i, x.v_i, x.p_i, x.w_i);
    const Vector4<S> p_ddot = RP<S>::from_reduced(body, x.c);
    const Matrix<S, 3, 4> G = G_matrix(x.p_i);
    EXPECT_LE(distance(p_ddot, G.transpose() * x.c / 2 - x.w_i.squaredNorm() / 4 * x.p_i), bound);
    // this is the p'' with omega_bar' = 2 G p'' and p . p'' = -p' . p'
    EXPECT_LE(distance(2 * G * p_ddot, x.c), bound);
    EXPECT_LE(error(x.p_i.dot(p_ddot), -body.p_dot.squaredNorm()), bound);
  }
}

TEST(Identities, BTimesPIsTwiceTheVector) {
  Random random(65);
  for (int n = 0; n < 100; ++n) {
    const Vector4<S> p = random.euler_parameters<S>();
    const Vec a = random.vector<S, 3>();
    EXPECT_LE(distance(RP<S>::B(p, a) * p, 2 * rotation_matrix(p) * a), bound);
  }
}

}  // namespace
}  // namespace trivium
