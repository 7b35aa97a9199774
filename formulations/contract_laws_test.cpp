/// The laws of contract/laws.hpp hold for every formulation, and wrong formulations violate them.

#include <gtest/gtest.h>

#include "formulations/contract/laws.hpp"
#include "formulations/contract/reduced_to_rotation.hpp"
#include "formulations/formulation_list.hpp"

namespace trivium {
namespace {

template <class F>
void expect_no_broken_law() {
  for (const BrokenLaw& broken : broken_laws<F>()) ADD_FAILURE() << broken.text();
}

TEST(ContractLaws, HoldForEveryFormulation) {
  for (const std::string& name : formulation_names())
    with_formulation<double>(name, []<Formulation F>() { expect_no_broken_law<F>(); });
}

TEST(ContractLaws, HoldForWhatIsReducedToRotation) {
  for (const std::string& name : formulation_names())
    with_formulation<double>(name, []<Formulation F>() { expect_no_broken_law<ReducedToRotation<F>>(); });
}

// formulations with one error each
struct WrongSignOfGyroscopicMoment : ROmega<double> {
  static Vector3<double> velocity_force(const Kinematics& k, const Matrix3<double>& J_bar) {
    return -ROmega<double>::velocity_force(k, J_bar);
  }
};
struct MassOffByAMillionth : RP<double> {
  static Matrix<double, 4, 4> mass_block(const Kinematics& k, const Matrix3<double>& J_bar) {
    return (1 + 1e-6) * RP<double>::mass_block(k, J_bar);
  }
};
struct InternalRowWithoutItsBias : RP<double> {
  static Vector<double, 1> internal_gamma(const Kinematics&) { return Vector<double, 1>::Zero(); }
};
struct MomentOfAnotherFrame : ROmega<double> {
  static Vector3<double> applied_force(const Kinematics& k, const Vector3<double>& n_bar) {
    return k.A * n_bar;
  }
};
struct StepTwiceAsFar : ROmega<double> {
  static Orientation step(const Chart& chart, const Orientation& p, const Vector3<double>& phi) {
    return ROmega<double>::step(chart, p, 2 * phi);
  }
};
struct ReducedForceWithoutGyroscopicMoment : RP<double> {
  static Vector3<double> reduced_force(const Kinematics&, const Matrix3<double>&,
                                       const Vector3<double>& n_bar) {
    return n_bar;
  }
};
struct AngularMotionWithoutDrift : REpsilon<double> {
  static AngularMotion<double> angular_motion(const Reduced& k) {
    AngularMotion<double> turn = REpsilon<double>::angular_motion(k);
    turn.drift.setZero();
    return turn;
  }
};
struct RetractsTwiceAsFar : ROmega<double> {
  static Orientation retract(const Chart& chart, const Orientation& p, const Vector3<double>& phi) {
    return ROmega<double>::retract(chart, p, 2 * phi);
  }
};
struct NormalisesPositionsAlone : RP<double> {
  static void normalise(Orientation& p, Unknown&) { p /= p.norm(); }
};
struct NormalisesByAnotherShare : RP<double> {
  static void normalise_step(Orientation& p, const double& share, Unknown& p_ddot) {
    RP<double>::normalise_step(p, 2 * share, p_ddot);
  }
};
struct NormalisesVelocitiesHalfway : RP<double> {
  static void normalise_step_velocity(const Orientation& p, const Unknown& p_dot, const double& share,
                                      Unknown& p_ddot) {
    RP<double>::normalise_step_velocity(p, p_dot, 2 * share, p_ddot);
  }
};
struct SaysThatItsMassIsConstant : RP<double> {
  static constexpr bool inertia_is_constant = true;
};
struct SaysThatItsReducedMassIsConstant : REpsilon<double> {
  static constexpr bool reduced_mass_is_constant = true;
};
struct PutsVelocitiesInPlaces : ROmega<double> {
  static Kinematics kinematics(const Chart& chart, const Vector3<double>& r, const Vector3<double>& r_dot,
                               const Coordinates& q) {
    return ROmega<double>::kinematics(chart, r_dot, r, q);
  }
};
struct KnowsNoDistance : ROmega<double> {
  static double chart_distance(const Chart&, const Coordinates&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
};
struct DisplacesAsIfFlat : ROmega<double> {
  static Unknown displacement_rate(const Unknown&, const Unknown& omega_bar) { return omega_bar; }
};
struct RetractsToNowhere : ROmega<double> {
  static Orientation retract(const Chart& chart, const Orientation& p, const Vector3<double>& phi) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return (phi.norm() < 1e-3 ? nan : 1.0) * ROmega<double>::retract(chart, p, phi);
  }
};

template <class F>
class AWrongFormulation : public testing::Test {};
using WrongFormulations =
    testing::Types<WrongSignOfGyroscopicMoment, MassOffByAMillionth, InternalRowWithoutItsBias,
                   MomentOfAnotherFrame, StepTwiceAsFar, ReducedForceWithoutGyroscopicMoment,
                   AngularMotionWithoutDrift, RetractsTwiceAsFar, NormalisesPositionsAlone,
                   NormalisesByAnotherShare, NormalisesVelocitiesHalfway, SaysThatItsMassIsConstant,
                   SaysThatItsReducedMassIsConstant, PutsVelocitiesInPlaces, KnowsNoDistance,
                   DisplacesAsIfFlat, RetractsToNowhere>;
TYPED_TEST_SUITE(AWrongFormulation, WrongFormulations);

TYPED_TEST(AWrongFormulation, IsFoundByTheLaws) { EXPECT_FALSE(broken_laws<TypeParam>().empty()); }

}  // namespace
}  // namespace trivium
