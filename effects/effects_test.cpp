/// Power, energy and laws of all effects; the laws detect effects with one error.

#include "effects/effect_laws.hpp"
#include "effects/effect_list.hpp"

#include "base/variants.hpp"
#include "bodies/numbers/quad.hpp"
#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"

namespace trivium {
namespace {

using test::distance, test::Random;
using S = Quad;
using Vec = Vector3<S>;
using TF = TimeFunction;

/// Two bodies and the ground in a smooth motion: r(t) = r + t r', A(t) = A exp(t tilde(omega_bar)).
struct Motion {
  std::vector<RigidBody<S>> bodies;
  std::vector<BodyMotion<S>> start;

  explicit Motion(std::uint64_t seed) {
    Random random(seed);
    for (int b = 0; b < 2; ++b) {
      bodies.push_back({S(random.uniform(0.5, 2)), Matrix3<S>::Identity()});
      start.push_back({random.vector<S, 3>(), random.vector<S, 3>(),
                       rotation_matrix(random.euler_parameters<S>()), random.vector<S, 3>()});
    }
    start.push_back({});
  }
  std::vector<BodyMotion<S>> at(const S& t) const {
    std::vector<BodyMotion<S>> motion = start;
    for (BodyMotion<S>& m : motion) {
      m.r += t * m.r_dot;
      m.A = (m.A * rotation_matrix(exponential_parameters<S>(t * m.omega_bar))).eval();
    }
    return motion;
  }
};

/// The sum of F . r' + n_bar . omega_bar over the bodies.
template <class E>
S power_of_wrenches(const E& effect, const Motion& motion) {
  std::vector<Wrench<S>> wrenches(motion.start.size());
  effect.apply(EffectView<S>{motion.bodies, motion.start, S(0)}, wrenches);
  S sum(0);
  for (std::size_t b = 0; b < wrenches.size(); ++b)
    sum += wrenches[b].F.dot(motion.start[b].r_dot) + wrenches[b].n_bar.dot(motion.start[b].omega_bar);
  return sum;
}

template <class E>
void expect_power_is_that_of_the_wrenches(const E& effect, const Motion& motion) {
  const S power = effect.power(EffectView<S>{motion.bodies, motion.start, S(0)});
  EXPECT_LE(std::abs(static_cast<double>(S(power - power_of_wrenches(effect, motion)))), 1e-30);
  EXPECT_GT(std::abs(static_cast<double>(power)), 1e-6);  // the test is not trivial
}

/// power = -dV/dt along the motion, by central differences.
template <class E>
void expect_conservative(const E& effect, const Motion& motion) {
  const S h(1e-11);
  const auto V = [&](const S& t) {
    const auto moved = motion.at(t);
    return effect.potential_energy(EffectView<S>{motion.bodies, moved, t});
  };
  const S rate = (V(h) - V(-h)) / (2 * h);
  const S power = effect.power(EffectView<S>{motion.bodies, motion.start, S(0)});
  EXPECT_LE(std::abs(static_cast<double>(S(power + rate))), 1e-18);
  EXPECT_GT(std::abs(static_cast<double>(power)), 1e-6);
}

/// Three components with different functions of time.
std::array<TF, 3> components() { return {TF(1.5), TF::Harmonic{0.5, 2, 3, 1}, TF::Polynomial{{-1, 2, 0.5}}}; }
std::array<TF, 3> numbers() { return {TF(1.5), TF(-2), TF(0.7)}; }

SpringDamper<S> spring(S damping, const TF& actuator) {
  Random random(91);
  return {"spring", {0, random.vector<S, 3>()}, {1, random.vector<S, 3>()}, S(12), damping, S(0.375),
          actuator};
}
TorsionalSpringDamper<S> torsional(const Motion& motion, S damping, const TF& actuator) {
  // at t = 0 the joint axes on i and j coincide: u_j is u_i rotated about z by atan2(0.8, 0.6)
  Random random(92);
  const Matrix3<S> frame = rotation_matrix(random.euler_parameters<S>());
  TorsionalSpringDamper<S> e;
  e.angle.i = 0;
  e.angle.j = 1;
  e.angle.u_bar_i = frame.col(0), e.angle.v_bar_i = frame.col(1), e.angle.z_bar_i = frame.col(2);
  const Vec u_j = motion.start[0].A * (frame * Vec(S(0.6), S(0.8), S(0)));
  e.angle.u_bar_j = motion.start[1].A.transpose() * u_j;
  e.stiffness = S(7);
  e.damping = damping;
  e.free_angle = S(0.25);
  e.actuator = actuator;
  return e;
}
/// Body 1 rotates like body 0 and in addition about the joint axis z with `rate` [rad/s], as in a revolute.
Motion joined_motion(std::uint64_t seed, const S& rate) {
  Motion motion(seed);
  const auto e = torsional(motion, S(0), {});
  const Vec omega_0 = motion.start[0].A * motion.start[0].omega_bar;
  motion.start[1].omega_bar =
      motion.start[1].A.transpose() * (omega_0 + rate * (motion.start[0].A * e.angle.z_bar_i));
  return motion;
}

constexpr int motions = 20;

TEST(Effects, PowerIsThatOfTheirWrenches) {
  for (int n = 0; n < motions; ++n) {
    const Motion motion(100 + n);
    const Vec s = Random(n).vector<S, 3>();
    expect_power_is_that_of_the_wrenches(Gravity<S>{"", Vec(S(1), S(2), S(-9.81))}, motion);
    for (const ComponentFrame frame : {ComponentFrame::global, ComponentFrame::body}) {
      expect_power_is_that_of_the_wrenches(Force<S>{"", 1, s, components(), frame}, motion);
      expect_power_is_that_of_the_wrenches(Torque<S>{"", 1, components(), frame}, motion);
    }
    expect_power_is_that_of_the_wrenches(spring(S(3), TF(1.25)), motion);
    const Motion joined = joined_motion(100 + n, S(1.7));
    expect_power_is_that_of_the_wrenches(torsional(joined, S(3), TF(1.25)), joined);
  }
}

TEST(Effects, PowerOfConservativeOnesIsTheLossOfTheirEnergy) {
  for (int n = 0; n < motions; ++n) {
    const Motion motion(200 + n);
    expect_conservative(Gravity<S>{"", Vec(S(1), S(2), S(-9.81))}, motion);
    expect_conservative(Force<S>{"", 1, Random(n).vector<S, 3>(), numbers(), ComponentFrame::global}, motion);
    expect_conservative(spring(S(0), {}), motion);
    const Motion joined = joined_motion(200 + n, S(1.7));
    expect_conservative(torsional(joined, S(0), {}), joined);
  }
}

// The following effects each violate one law.

/// nonconservative_power omits the damper.
struct ForgetfulSpring : SpringDamper<S> {
  S nonconservative_power(const EffectView<S>&) const { return S(0); }
};

/// `gradient` exchanges the two bodies.
struct TurnedSpring : SpringDamper<S> {
  std::pair<Wrench<S>, Wrench<S>> gradient(const EffectView<S>& view) const {
    const auto [on_i, on_j] = SpringDamper<S>::gradient(view);
    return {on_j, on_i};
  }
};
/// `sees_motion` is false, but the force depends on positions.
struct BlindSpring : SpringDamper<S> {
  static constexpr bool sees_motion = false;
};

/// `sees_motion` is false, but n_bar depends on A: the components of the torque are global.
struct BlindTorque : Torque<S> {
  static constexpr bool sees_motion = false;
};

/// Its keys omit stiffness, damping and free length.
struct SecretiveSpring : SpringDamper<S> {
  static void keys(auto&& show, auto&... e) {
    show.point("i", e.i...);
    show.point("j", e.j...);
    show.may("actuator", e.actuator...);
  }
};

/// The energy contains a constant that its keys omit.
struct SecretiveGravity : Gravity<S> {
  S level{0};
  S potential_energy(const EffectView<S>& view) const { return Gravity<S>::potential_energy(view) + level; }
};
/// `follow` changes the torque.
struct RestlessTorque : Torque<S> {
  S times{1};
  void apply(const EffectView<S>& view, std::span<Wrench<S>> wrenches) const {
    for (S k(0); k < times; k += S(1)) Torque<S>::apply(view, wrenches);
  }
  S power(const EffectView<S>& view) const { return times * Torque<S>::power(view); }
  void follow(const EffectView<S>&) { times = S(2); }
};
/// append_kinks omits the kinks of its functions of time.
struct SmoothForce : Force<S> {
  void append_kinks(std::vector<double>&) const {}
};

/// Assigns random values to the parts of an effect between two bodies with a joint.
struct DrawnParts : ValueVisitor<DrawnParts> {
  Random& random;
  const JointAngle<S>& joined;
  int next = 0;  ///< the body of the next point

  DrawnParts(Random& from, const JointAngle<S>& angle) : random(from), joined(angle) {}

  void body(std::string_view, int& index) const { index = 1; }
  void point(std::string_view, BodyPoint<S>& end) { end = {next++ % 2, random.vector<S, 3>()}; }
  void joint(std::string_view, JointAngle<S>& angle) const { angle = joined; }
  void value(std::string_view, S& x) const {
    x = S((random.uniform() > 0 ? 1 : -1) * random.uniform(0.5, 3));
  }
  void value(std::string_view, Vec& v) const { v = random.vector<S, 3>(); }
  void value(std::string_view, ComponentFrame& frame) const {
    frame = random.uniform() > 0 ? ComponentFrame::global : ComponentFrame::body;
  }
  void value(std::string_view, TF& f) const { f = TF(1.25); }
  void value(std::string_view, std::array<TF, 3>& f) const {
    f = random.uniform() > 0 ? numbers() : components();
  }
};

TEST(EffectLaws, HoldForEveryEffectOfTheListAndFindOneThatBreaksThem) {
  for (int n = 0; n < motions; ++n) {
    const Motion motion = joined_motion(600 + n, S(1.7));
    const auto broken = [&](const auto& effect) {
      return broken_laws(effect, motion.bodies, motion.start, S(0));
    };
    Random random(n);
    using Any = StandardEffects::OneOf<S>;
    for (std::size_t k = 0; k < std::variant_size_v<Any>; ++k) {
      auto any = emplaced<Any>(k);
      std::visit(
          [&](auto& effect) {
            effect.keys(DrawnParts(random, torsional(motion, S(0), {}).angle), effect);
            for (const BrokenLaw& law : broken(effect)) ADD_FAILURE() << effect.type << ": " << law.text();
          },
          any);
    }
    EXPECT_FALSE(broken(ForgetfulSpring{spring(S(3), TF(1.25))}).empty());
    EXPECT_FALSE(broken(SecretiveSpring{spring(S(3), TF(1.25))}).empty());
    EXPECT_FALSE(broken(TurnedSpring{spring(S(3), TF(1.25))}).empty());
    EXPECT_FALSE(broken(BlindSpring{spring(S(3), TF(1.25))}).empty());
    EXPECT_FALSE(broken(BlindTorque{{"", 1, numbers(), ComponentFrame::global}}).empty());
    EXPECT_FALSE(broken(SecretiveGravity{{"", Vec(S(1), S(2), S(-9.81))}, S(5)}).empty());
    EXPECT_FALSE(broken(RestlessTorque{{"", 1, numbers(), ComponentFrame::global}}).empty());
    const TF kinked = TF::Step5{0.5, 0, 1, 2};
    EXPECT_FALSE(broken(SmoothForce{{"", 1, Vec::Zero(), {kinked, TF(1), TF(1)}}}).empty());
  }
}

TEST(Effects, SumOfAllIsTheSumOfEach) {
  const Motion motion = joined_motion(300, S(0.9));
  Effects<S> all;
  all.add(Gravity<S>{"", Vec(S(0), S(0), S(-9.81))});
  all.add(Force<S>{"", 0, Vec::Zero(), numbers()});
  all.add(Force<S>{"", 1, Vec::Ones(), components(), ComponentFrame::body});
  all.add(Torque<S>{"", 0, components()});
  all.add(spring(S(3), TF(1)));
  all.add(torsional(motion, S(2), TF(1)));
  expect_power_is_that_of_the_wrenches(all, motion);
  const EffectView<S> view{motion.bodies, motion.start, S(0)};
  const S energy = all.all<Gravity<S>>()[0].potential_energy(view) +
                   all.all<Force<S>>()[0].potential_energy(view) +
                   all.all<SpringDamper<S>>()[0].potential_energy(view) +
                   all.all<TorsionalSpringDamper<S>>()[0].potential_energy(view);
  EXPECT_LE(std::abs(static_cast<double>(S(all.potential_energy(view) - energy))), 1e-31);
}

TEST(Gravity, ActsOnBodiesAndNotOnTheGround) {
  const Motion motion(301);
  std::vector<Wrench<S>> wrenches(3);
  Gravity<S>{"", Vec(S(0), S(0), S(-10))}.apply({motion.bodies, motion.start, S(0)}, wrenches);
  for (int b = 0; b < 2; ++b) EXPECT_EQ(wrenches[b].F[2], -10 * motion.bodies[b].mass);
  EXPECT_EQ(wrenches[2].F, Vec::Zero());
}

TEST(Force, FrameSaysWhichWayItsComponentsPoint) {
  const Motion motion(302);
  const Vec F(S(1.5), S(-2), S(0.7));
  for (const auto& [frame, expected] :
       {std::pair{ComponentFrame::global, F}, std::pair{ComponentFrame::body, Vec(motion.start[1].A * F)}}) {
    std::vector<Wrench<S>> wrenches(3);
    Force<S>{"", 1, Vec::Zero(), numbers(), frame}.apply({motion.bodies, motion.start, S(0)}, wrenches);
    EXPECT_LE(distance(wrenches[1].F, expected), 1e-32);
    EXPECT_EQ(wrenches[1].n_bar, Vec::Zero());
  }
}

TEST(Torque, FrameSaysWhichWayItsComponentsPoint) {
  const Motion motion(303);
  const Vec n(S(1.5), S(-2), S(0.7));
  for (const auto& [frame, expected] :
       {std::pair{ComponentFrame::body, n},
        std::pair{ComponentFrame::global, Vec(motion.start[1].A.transpose() * n)}}) {
    std::vector<Wrench<S>> wrenches(3);
    Torque<S>{"", 1, numbers(), frame}.apply({motion.bodies, motion.start, S(0)}, wrenches);
    EXPECT_LE(distance(wrenches[1].n_bar, expected), 1e-32);
    EXPECT_EQ(wrenches[1].F, Vec::Zero());
  }
}

TEST(Force, OnlyAConstantGlobalOneStoresEnergy) {
  const Motion motion(304);
  const EffectView<S> view{motion.bodies, motion.start, S(0)};
  EXPECT_NE((Force<S>{"", 1, Vec::Ones(), numbers(), ComponentFrame::global}.potential_energy(view)), S(0));
  EXPECT_EQ((Force<S>{"", 1, Vec::Ones(), numbers(), ComponentFrame::body}.potential_energy(view)), S(0));
  EXPECT_EQ((Force<S>{"", 1, Vec::Ones(), components(), ComponentFrame::global}.potential_energy(view)),
            S(0));
}

// the power of a damper with damping 1 is -x'^2, with x' the power of the gradient
TEST(Effects, GradientsTellHowFastTheirLengthOrAngleGrows) {
  const auto rate_of = [](const auto& effect, const Motion& motion) {
    const auto gradient = effect.gradient(EffectView<S>{motion.bodies, motion.start, S(0)});
    const auto along = [&](const Wrench<S>& on, int b) {
      return S(on.F.dot(motion.start[b].r_dot) + on.n_bar.dot(motion.start[b].omega_bar));
    };
    const auto [i, j] = effect.bodies();
    return S(along(gradient.first, i) + along(gradient.second, j));
  };
  const auto expect = [&](auto effect, const Motion& motion) {
    effect.stiffness = S(0);
    effect.damping = S(1);
    const S power = effect.power(EffectView<S>{motion.bodies, motion.start, S(0)}),
            rate = rate_of(effect, motion);
    EXPECT_LE(std::abs(static_cast<double>(S(power + rate * rate))), 1e-30);
    EXPECT_GT(std::abs(static_cast<double>(rate)), 1e-6);
  };
  for (std::uint64_t seed = 0; seed < motions; ++seed) {
    const Motion motion(seed);
    expect(spring(S(1), {}), motion);
    const Motion joined = joined_motion(seed, S(1.5));
    expect(torsional(joined, S(1), {}), joined);
  }
}

}  // namespace
}  // namespace trivium
