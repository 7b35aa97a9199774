/// Mechanisms and states made from scenes, in every Scalar.

#include "scenes/make_mechanism.hpp"
#include "mechanism/additions.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string>
#include <utility>

#include "bodies/inertia.hpp"
#include "bodies/numbers/quad.hpp"
#include "bodies/numbers/real50.hpp"
#include "bodies/numbers/scalar.hpp"
#include "bodies/rotations/euler_angles.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "scenes/scene_state.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium {
namespace {

using test::distance;

TEST(Mechanism, GroundIsTheLastBody) {
  scenes::Scene scene;
  scene.bodies = {test::body("a", 1), test::body("b", 2)};
  scene.constraints = {test::joint(JointType::spherical, "s", {}, test::side(1))};
  const auto mechanism = make_mechanism<double>(scene);
  EXPECT_EQ(mechanism.body_names, (std::vector<std::string>{"a", "b", "ground"}));
  EXPECT_EQ(mechanism.nb(), 2);
  EXPECT_EQ(mechanism.joints[0].i, mechanism.ground());
  EXPECT_EQ(mechanism.joints[0].j, 1);
  for (const auto& row : mechanism.rows) {
    EXPECT_EQ(bodies_of(row).i, 2);
    EXPECT_EQ(bodies_of(row).j, 1);
  }
}

TEST(Mechanism, RowsStandInFileOrderUnderTheNamesOfTheirJoints) {
  const scenes::Vector3 z{0, 0, 1}, x{1, 0, 0};
  scenes::Scene scene;
  scene.bodies = {test::body("a", 1)};
  scenes::Side ground = test::side(scenes::ground, {}, z, x), a = test::side(0, {}, z, x);
  ground.vector = x;
  a.vector = z;
  const std::vector<std::pair<ConstraintType, int>> rows{
      {basic_type<DP1>, 1},     {basic_type<DP2>, 1},        {basic_type<D>, 1},
      {basic_type<CD>, 1},      {JointType::spherical, 3},   {JointType::universal, 4},
      {JointType::revolute, 5}, {JointType::cylindrical, 4}, {JointType::translational, 5},
      {JointType::fixed, 6},    {JointType::planar, 3},      {JointType::in_line, 2},
      {JointType::in_plane, 1}, {JointType::distance, 1},    {JointType::rotation_driver, 1}};
  for (const auto& [type, count] : rows)
    scene.constraints.push_back(test::joint(type, fmt::format("c{}", scene.constraints.size()), ground, a));
  const auto mechanism = make_mechanism<double>(scene);
  ASSERT_EQ(mechanism.joints.size(), rows.size());
  int next = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(mechanism.joints[k].type, rows[k].first);
    EXPECT_EQ(mechanism.joints[k].first_row, next);
    EXPECT_EQ(mechanism.joints[k].rows, rows[k].second) << k;
    next += rows[k].second;
  }
  EXPECT_EQ(mechanism.nc(), next);
  // The row of a basic constraint has the name of the constraint. The rows of a joint append their labels.
  EXPECT_EQ(mechanism.row_names[0], "c0");
  EXPECT_EQ(mechanism.row_names[4], "c4.cd(e_x)");
  EXPECT_EQ(mechanism.row_names[mechanism.joints[6].first_row + 4], "c6.dp1(v_i, z_j)");
  EXPECT_EQ(mechanism.row_names.back(), "c14.dp1(w_i, u_j)");
}

/// The rows of a joint as the table of docs/scene_format.md lists them, such as "cd(e_x), cd(e_y), cd(e_z)".
std::string rows_on_the_page(const std::string& type) {
  std::ifstream page(TRIVIUM_DOCS_DIR "/scene_format.md");
  const std::string start = "| `" + type + "` | ";
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with(start) || line.find("dp") == line.find("cd(")) continue;
    std::string rows = line.substr(start.size(), line.size() - start.size() - 2);
    if (const std::string others = "those of "; rows.starts_with(others)) {
      const std::size_t end = rows.find(',');
      rows = rows_on_the_page(rows.substr(others.size(), end - others.size())) + rows.substr(end);
    }
    return rows;
  }
  return {};
}

TEST(Mechanism, RowsOfAJointAreThoseOfTheFormatsPage) {
  const scenes::Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  for (const auto& [type, name] : {std::pair{JointType::spherical, "spherical"},
                                   {JointType::universal, "universal"},
                                   {JointType::revolute, "revolute"},
                                   {JointType::cylindrical, "cylindrical"},
                                   {JointType::translational, "translational"},
                                   {JointType::fixed, "fixed"},
                                   {JointType::planar, "planar"},
                                   {JointType::in_line, "in_line"},
                                   {JointType::in_plane, "in_plane"}}) {
    scenes::Scene scene;
    scene.bodies = {test::body("a", 1)};
    const auto& axis_j = type == JointType::universal ? y : z;
    scene.constraints = {
        test::joint(type, "j", test::side(scenes::ground, {}, z, x), test::side(0, {}, axis_j, x))};
    std::string rows;
    for (const std::string& row : make_mechanism<double>(scene).row_names)
      rows += (rows.empty() ? "" : ", ") + row.substr(2);
    EXPECT_EQ(rows, rows_on_the_page(name)) << name;
  }
}

TEST(Mechanism, ABodyAndAConstraintAddedInCppAreThoseOfAScene) {
  scenes::Scene scene;
  scene.bodies = {test::body("a", 1), test::body("b", 2, {1, 2, 3}, {1, 0, 0})};
  scene.constraints = {
      test::joint(JointType::revolute, "hinge", test::side(scenes::ground, {}, {{0, 0, 1}}),
                  test::side(0, {}, {{0, 0, 1}})),
      test::joint(basic_type<D>, "rope", test::side(scenes::ground, scenes::Vector3{0, 0, 1}),
                  test::side(1, scenes::Vector3{0.1, 0.2, 0.3}))};
  scene.constraints[1].f = 4;
  SpringDamper<double> spring;
  spring.i = {scenes::ground, {1, 2, 3}};
  spring.j = {0, {4, 5, 6}};
  scene.effects = {spring};
  const auto whole = make_model<double>(scene);

  scenes::Scene less = scene;
  less.bodies.pop_back();
  less.constraints.pop_back();
  auto model = make_model<double>(less);
  const int b = add_body(model, "b", whole.mechanism.bodies[1], whole.state.pose[1], whole.state.twist[1]);
  add_constraint<double, StandardTypes>(
      model.mechanism, "rope", D<double>{{model.mechanism.ground(), b}, {0, 0, 1}, {0.1, 0.2, 0.3}, 4.0});
  const Mechanism<double>&added = model.mechanism, &stated = whole.mechanism;
  EXPECT_EQ(added.body_names, stated.body_names);
  EXPECT_EQ(added.row_names, stated.row_names);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(added.joints[k].type, stated.joints[k].type);
    EXPECT_EQ(added.joints[k].i, stated.joints[k].i);
    EXPECT_EQ(added.joints[k].j, stated.joints[k].j);
    EXPECT_EQ(added.joints[k].frame_i.point, stated.joints[k].frame_i.point);
    EXPECT_EQ(added.joints[k].frame_j.point, stated.joints[k].frame_j.point);
  }
  for (int k = 0; k < added.nc(); ++k) EXPECT_EQ(bodies_of(added.rows[k]).i, bodies_of(stated.rows[k]).i);
  const auto& moved = added.effects.all<SpringDamper<double>>()[0];
  EXPECT_EQ(moved.bodies(), std::pair(2, 0));
}

TEST(Mechanism, JointFramesComeFromTheScenesAxes) {
  scenes::Scene scene;
  scene.bodies = {test::body("a", 1)};
  scene.constraints = {
      test::joint(JointType::revolute, "r",
                  test::side(scenes::ground, scenes::Vector3{1, 2, 3}, scenes::Vector3{0, 2, 0}),
                  test::side(0, {}, scenes::Vector3{0, 0, -3}, scenes::Vector3{0, 5, 4}))};
  const auto joint = make_mechanism<double>(scene).joints[0];
  EXPECT_EQ(joint.frame_i.point, (Vector3<double>(1, 2, 3)));
  EXPECT_EQ(joint.frame_i.z, (Vector3<double>(0, 1, 0)));
  EXPECT_EQ(joint.frame_i.u, (Vector3<double>(1, 0, 0)));
  EXPECT_EQ(joint.frame_j.point, (Vector3<double>(0, 0, 0)));
  EXPECT_EQ(joint.frame_j.z, (Vector3<double>(0, 0, -1)));
  EXPECT_EQ(joint.frame_j.u, (Vector3<double>(0, 1, 0)));
  EXPECT_EQ(joint.frame_j.v, (Vector3<double>(1, 0, 0)));
}

TEST(Mechanism, JointFramesAreTheSameInEveryScalar) {
  const auto u = []<class Scalar>(Scalar) {
    scenes::Scene scene;
    scene.bodies = {test::body("a", 1)};
    const scenes::Vector3 axis{1, 1 - 1e-12, 5};  // x and y are equal after rounding to float
    scene.constraints = {
        test::joint(JointType::revolute, "r", test::side(scenes::ground, {}, axis), test::side(0, {}, axis))};
    return scalar_cast<double>(make_mechanism<Scalar>(scene).joints[0].frame_i.u);
  };
  EXPECT_LE(distance(u(1.0f), u(1.0)), test::roundings<float>(8));
  EXPECT_LE(distance(u(Quad(1)), u(1.0)), test::roundings<double>(8));
}

TEST(Mechanism, VectorsOfBasicConstraintsAreTakenAsWritten) {
  scenes::Scene scene;
  scene.bodies = {test::body("a", 1)};
  auto dp1 = test::joint(basic_type<DP1>, "dp1", test::vector_side(scenes::ground, {2, 0, 0}),
                         test::vector_side(0, {3, 4, 0}));
  dp1.f = 5.0;
  scene.constraints = {dp1};
  const auto mechanism = make_mechanism<double>(scene);
  const auto& row = std::get<DP1<double>>(mechanism.rows[0]);
  EXPECT_EQ(row.a_bar_i, (Vector3<double>(2, 0, 0)));
  EXPECT_EQ(row.a_bar_j, (Vector3<double>(3, 4, 0)));
  EXPECT_EQ(row.f, TimeFunction(5.0));
}

TEST(Mechanism, InertiaIsDiagonalOrFull) {
  scenes::Scene scene;
  scene.bodies = {test::body("diagonal", 1), test::body("full", 1)};
  scene.bodies[0].inertia = scenes::Vector3{1, 2, 3};
  scene.bodies[1].inertia = scenes::Matrix3{{{2, 0.1, 0.2}, {0.1, 3, 0.3}, {0.2, 0.3, 4}}};
  const auto mechanism = make_mechanism<double>(scene);
  EXPECT_EQ(mechanism.bodies[0].inertia, (Matrix3<double>(Vector3<double>(1, 2, 3).asDiagonal())));
  const Matrix3<double> full = (Matrix3<double>() << 2, 0.1, 0.2, 0.1, 3, 0.3, 0.2, 0.3, 4).finished();
  EXPECT_EQ(mechanism.bodies[1].inertia, full);
}

/// The reader accepts slightly negative moments within its tolerance; the mechanism must not contain them.
TEST(Mechanism, AMomentJustBelowZeroCountsAsZero) {
  const scenes::Vector3 moments{2, 2, -1e-12};
  scenes::Scene scene;
  scene.bodies = {test::body("diagonal", 1, moments), test::body("full", 1), test::body("singular", 1)};
  test::Random random(7);
  const Matrix3<double> A = rotation_matrix(random.euler_parameters<double>());
  const Matrix3<double> J = A * Vector3<double>(moments.data()).asDiagonal() * A.transpose();
  const scenes::Matrix3 exactly_singular{{{1, 1, 0}, {1, 1, 0}, {0, 0, 2}}};
  scenes::Matrix3 rows;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) rows[r][c] = J(r, c);
  scene.bodies[1].inertia = rows;
  scene.bodies[2].inertia = exactly_singular;
  const auto mechanism = make_mechanism<double>(scene);
  EXPECT_EQ(mechanism.bodies[0].inertia, (Matrix3<double>(Vector3<double>(2, 2, 0).asDiagonal())));
  const auto lifted = check_inertia(mechanism.bodies[1].inertia).principal_moments;
  EXPECT_LE(std::abs(lifted[0]), 4e-15);  // rounding error for a trace of 4
  EXPECT_LE(distance(mechanism.bodies[1].inertia, J), 1.1e-12);
  for (int r = 0; r < 3; ++r)  // an exactly singular matrix is not changed
    EXPECT_EQ(mechanism.bodies[2].inertia.row(r), Vector3<double>(exactly_singular[r].data()).transpose());
}

TEST(Orientation, IsTheSameInAllFourForms) {
  const EulerSequence sequence = *parse_euler_sequence("312");
  const Vector3<Quad> angles(Quad(0.3), Quad(-0.4), Quad(1.2));
  const Matrix3<Quad> A = euler_rotation(sequence, angles);
  const auto rotation = [](const scenes::Orientation& o) {
    return rotation_matrix(euler_parameters_of<Quad>(o));
  };
  EXPECT_LE(distance(rotation(scenes::EulerAngles{{0.3, -0.4, 1.2}, sequence}), A), 1e-32);

  scenes::RotationMatrix matrix;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) matrix.A[r][c] = static_cast<double>(A(r, c));
  EXPECT_LE(distance(rotation(matrix), A), 1e-15);

  const Vector4<double> p = scalar_cast<double>(euler_parameters(A));
  EXPECT_LE(distance(rotation(scenes::EulerParameters{{3 * p[0], 3 * p[1], 3 * p[2], 3 * p[3]}}), A), 1e-15);

  const Vector3<double> e = p.tail<3>();
  const double angle = 2 * std::atan2(e.norm(), p[0]);
  EXPECT_LE(distance(rotation(scenes::AxisAngle{{5 * e[0], 5 * e[1], 5 * e[2]}, angle}), A), 1e-15);
}

TEST(Orientation, IsUnitToTheLastBitOfEveryScalar) {
  const scenes::EulerParameters written{{0.7, 0.1, -0.3, 0.2}};
  EXPECT_NEAR(euler_parameters_of<double>(written).norm(), 1, 2e-16);
  EXPECT_LE(std::abs(static_cast<double>(Quad(euler_parameters_of<Quad>(written).norm() - 1))), 2e-34);
  EXPECT_LE(std::abs(static_cast<double>(Real50(euler_parameters_of<Real50>(written).norm() - 1))), 1e-49);
}

/// A vector that a scene normalises has the same direction at every magnitude of the format, even in float.
template <class Scalar>
class EverySize : public testing::Test {
 public:
  static constexpr std::array sizes = {1e-99, 1e-50, 3.0, 1e50, 1e99};
  /// A few roundings of Scalar, but at least those of the doubles that state the vectors.
  const double tolerance = std::max(test::roundings<Scalar>(8), test::roundings<double>(8));
};
using Scalars = testing::Types<float, double, Quad>;
TYPED_TEST_SUITE(EverySize, Scalars);

TYPED_TEST(EverySize, OfEulerParametersIsTheSameOrientation) {
  const Vector4<TypeParam> expected =
      euler_parameters_of<TypeParam>(scenes::EulerParameters{{0.7, 0.1, -0.3, 0.2}});
  for (double s : this->sizes)
    EXPECT_LE(distance(euler_parameters_of<TypeParam>(
                           scenes::EulerParameters{{0.7 * s, 0.1 * s, -0.3 * s, 0.2 * s}}),
                       expected),
              this->tolerance)
        << s;
}

TYPED_TEST(EverySize, OfAnAxisIsTheSameTurn) {
  const Vector4<TypeParam> expected = euler_parameters_of<TypeParam>(scenes::AxisAngle{{2, -3, 6}, 0.8});
  for (double s : this->sizes)
    EXPECT_LE(
        distance(euler_parameters_of<TypeParam>(scenes::AxisAngle{{2 * s, -3 * s, 6 * s}, 0.8}), expected),
        this->tolerance)
        << s;
}

TYPED_TEST(EverySize, OfAJointsAxesIsTheSameFrame) {
  const auto frame = [](double s) {
    scenes::Scene scene;
    scene.bodies = {test::body("a", 1)};
    scene.constraints = {test::joint(
        JointType::fixed, "f",
        test::side(scenes::ground, {}, scenes::Vector3{2 * s, -3 * s, 6 * s}, scenes::Vector3{s, 0, s}),
        test::side(0, {}, scenes::Vector3{2 / s, -3 / s, 6 / s}, scenes::Vector3{1 / s, 0, 1 / s}))};
    return make_mechanism<TypeParam>(scene).joints[0];
  };
  const auto expected = frame(1);
  for (double s : this->sizes) {
    const auto joint = frame(s);
    EXPECT_LE(distance(joint.frame_i.z, expected.frame_i.z), this->tolerance) << s;
    EXPECT_LE(distance(joint.frame_i.u, expected.frame_i.u), this->tolerance) << s;
    EXPECT_LE(distance(joint.frame_j.z, expected.frame_j.z), this->tolerance) << s;
    EXPECT_LE(distance(joint.frame_j.u, expected.frame_j.u), this->tolerance) << s;
  }
}

TEST(MechanismState, SurvivesBeingWrittenBack) {
  test::Random random(81);
  scenes::Scene scene;
  scene.bodies = {test::body("a", 1), test::body("b", 2)};
  MechanismState<double> state;
  for (int b = 0; b < 2; ++b) {
    state.pose.push_back({random.vector<double, 3>(), random.euler_parameters<double>()});
    state.twist.push_back({random.vector<double, 3>(), random.vector<double, 3>()});
  }
  set_state(scene, state);
  const auto back = make_state<double>(scene, 2.5);
  EXPECT_EQ(back.t, 2.5);
  for (int b = 0; b < 2; ++b) {
    EXPECT_EQ(back.pose[b].r, state.pose[b].r);
    EXPECT_LE(distance(back.pose[b].p, state.pose[b].p), 4e-16);
    EXPECT_EQ(back.twist[b].r_dot, state.twist[b].r_dot);
    EXPECT_EQ(back.twist[b].omega_bar, state.twist[b].omega_bar);
  }
}

}  // namespace
}  // namespace trivium
