/// Joint frames, the rows of every joint, and the motions that every joint leaves free.

#include "constraints/joint.hpp"

#include <Eigen/QR>
#include <map>

#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "constraints/constraint_row.hpp"
#include "constraints/testing/moving_plain_body.hpp"

namespace trivium {
namespace {

using test::distance, test::for_all, test::Random;
using Frame = JointFrame<double>;
using Body = PlainBody<double>;
using Vec = Vector3<double>;
constexpr double pi = 3.14159265358979323846;

// ---- frames

TEST(JointFrame, IsOrthonormalAndRightHanded) {
  for_all([] {
    const Vec axis = test::draw_vector<double, 3>(3), x = test::draw_vector<double, 3>(3);
    if (axis.cross(x).norm() < 1e-2) return;
    const Frame f = joint_frame<double>(Vec(1, 2, 3), axis, x);
    Matrix3<double> A;
    A << f.u, f.v, f.z;
    RC_ASSERT(distance(A.transpose() * A, Matrix3<double>::Identity()) <= 1e-10);
    RC_ASSERT(A.determinant() > 0);
    RC_ASSERT(distance(f.z * axis.norm(), axis) <= 1e-14);
    RC_ASSERT(f.u.dot(x) > 0);  // u has the direction of x minus its component along z
    RC_ASSERT(std::abs(f.v.dot(x)) <= 1e-10);
    RC_ASSERT(f.point == Vec(1, 2, 3));
  });
}

TEST(JointFrame, DefaultXIsTheAxisLeastAlongZAndTheLowestOnTies) {
  const auto u_of = [](const Vec& axis) { return joint_frame<double>(Vec::Zero(), axis, default_x(axis)).u; };
  EXPECT_EQ(u_of({0, 0, 1}), Vec(1, 0, 0));
  EXPECT_EQ(u_of({0, 0, -2}), Vec(1, 0, 0));
  EXPECT_EQ(u_of({0, 1, 0}), Vec(1, 0, 0));
  EXPECT_EQ(u_of({1, 0, 0}), Vec(0, 1, 0));
  EXPECT_EQ(u_of({3, 3, 0}), Vec(0, 0, 1));
  EXPECT_EQ(u_of({3, 0, -3}), Vec(0, 1, 0));
  EXPECT_LE(distance(u_of({1, 1, 1}), Vec(2, -1, -1) / std::sqrt(6.0)), 1e-15);
  EXPECT_LE(distance(u_of({1, -1, -1}), Vec(2, 1, 1) / std::sqrt(6.0)), 1e-15);
  EXPECT_LE(distance(u_of({0.2, -0.3, 0.1}), joint_frame<double>(Vec::Zero(), {0.2, -0.3, 0.1}, {0, 0, 1}).u),
            1e-15);
}

// ---- rows

/// The rows of each joint as documented in the scene format.
const std::map<std::string, std::vector<std::string>> expected_rows = [] {
  using Names = std::vector<std::string>;
  const auto join = [](Names a, const Names& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  const Names spherical{"cd(e_x)", "cd(e_y)", "cd(e_z)"}, parallel{"dp1(u_i, z_j)", "dp1(v_i, z_j)"},
      line{"dp2(u_i)", "dp2(v_i)"}, no_turn{"dp1(u_i, v_j)"};
  return std::map<std::string, Names>{{"spherical", spherical},
                                      {"universal", join(spherical, {"dp1(z_i, z_j)"})},
                                      {"revolute", join(spherical, parallel)},
                                      {"cylindrical", join(parallel, line)},
                                      {"translational", join(join(parallel, line), no_turn)},
                                      {"fixed", join(join(spherical, parallel), no_turn)},
                                      {"planar", join(parallel, {"dp2(z_i)"})},
                                      {"in_line", line},
                                      {"in_plane", {"dp2(z_i)"}},
                                      {"distance", {"d"}},
                                      {"rotation_driver", {"dp1(w_i, u_j)"}}};
}();

JointRows<double> build(const std::string& type, const Frame& i, const Frame& j, double length = 1,
                        const TimeFunction& alpha = {}) {
  const JointBuilder<double> b({0, 1}, i, j);
  if (type == "spherical") return b.spherical();
  if (type == "universal") return b.universal();
  if (type == "revolute") return b.revolute();
  if (type == "cylindrical") return b.cylindrical();
  if (type == "translational") return b.translational();
  if (type == "fixed") return b.fixed();
  if (type == "planar") return b.planar();
  if (type == "in_line") return b.in_line();
  if (type == "in_plane") return b.in_plane();
  if (type == "distance") return b.distance(length);
  return b.rotation_driver(alpha);
}

TEST(Joints, RowsStandInTheDocumentedOrderUnderTheDocumentedNames) {
  for (const auto& [type, names] : expected_rows) {
    std::vector<std::string> found;
    for (const auto& row : build(type, {}, {})) found.push_back(row.label);
    EXPECT_EQ(found, names) << type;
  }
}

/// Phi of a row, computed independently from its label.
double phi_by_label(const std::string& label, const Body& bi, const Frame& fi, const Body& bj,
                    const Frame& fj, double length, double alpha) {
  const Vec d = (bj.r + bj.A * fj.point) - (bi.r + bi.A * fi.point);
  const std::map<char, Vec> on_i{{'u', bi.A * fi.u},
                                 {'v', bi.A * fi.v},
                                 {'z', bi.A * fi.z},
                                 {'w', bi.A * (-std::sin(alpha) * fi.u + std::cos(alpha) * fi.v)}};
  const std::map<char, Vec> on_j{{'u', bj.A * fj.u}, {'v', bj.A * fj.v}, {'z', bj.A * fj.z}};
  if (label == "d") return d.squaredNorm() - length * length;
  if (label.starts_with("cd(e_")) return d[label[5] - 'x'];
  if (label.starts_with("dp2(")) return on_i.at(label[4]).dot(d);
  return on_i.at(label[4]).dot(on_j.at(label[9]));
}

Frame draw_frame(Random& random) {
  const Vec x = random.direction<double>(), axis = random.direction<double>();
  return joint_frame<double>(random.vector<double, 3>(), axis, x);
}

TEST(Joints, EveryRowIsWhatItsNameSays) {
  Random random(31);
  for (int n = 0; n < 30; ++n)
    for (const auto& [type, names] : expected_rows) {
      const Body bi = test::random_plain_body<double>(random).now,
                 bj = test::random_plain_body<double>(random).now;
      const Frame fi = draw_frame(random), fj = draw_frame(random);
      const double length = random.uniform(0.5, 2), alpha = random.uniform(-3, 3);
      for (const auto& row : build(type, fi, fj, length, alpha))
        EXPECT_NEAR(evaluate_row(row.constraint, bi, bj, 0.0).phi,
                    phi_by_label(row.label, bi, fi, bj, fj, length, alpha), 1e-13)
            << type << " " << row.label;
    }
}

// ---- freedoms

/// A velocity of body j relative to body i [global]: a translation and a rotation about the joint point on j.
struct Freedom {
  Vec translation, rotation;
};

/// A joint in a position that satisfies its rows: frame j is frame i after a finite allowed motion.
struct Placed {
  Body i, j;
  Frame fi, fj;
  double length = 1, angle = 0;
  Vec P_j, u, v, z;  ///< joint point on j, joint axes on i [global]
};

Placed place(const std::string& type, Random& random) {
  Placed s;
  s.i = test::random_plain_body<double>(random).now;
  s.j = test::random_plain_body<double>(random).now;
  s.fi = draw_frame(random);
  s.u = s.i.A * s.fi.u;
  s.v = s.i.A * s.fi.v;
  s.z = s.i.A * s.fi.z;
  const Vec P_i = s.i.r + s.i.A * s.fi.point;
  const double x = random.uniform(), y = random.uniform(), w = random.uniform();
  s.P_j = P_i;
  if (type == "cylindrical" || type == "translational" || type == "in_line") s.P_j += w * s.z;
  if (type == "planar" || type == "in_plane") s.P_j += x * s.u + y * s.v;
  if (type == "distance" || type == "rotation_driver") s.P_j += x * s.u + y * s.v + w * s.z;
  s.length = (s.P_j - P_i).norm();
  s.angle = random.uniform(-pi, pi);
  const bool turned = type != "fixed" && type != "translational";
  Vec z_j = s.z, u_j = turned ? Vec(std::cos(s.angle) * s.u + std::sin(s.angle) * s.v) : s.u;
  if (type == "universal") z_j = u_j;
  if (type == "spherical" || type == "in_line" || type == "in_plane" || type == "distance")
    z_j = random.direction<double>();
  if (z_j != s.z) u_j = random.direction<double>();
  s.fj = joint_frame<double>(s.j.A.transpose() * (s.P_j - s.j.r), s.j.A.transpose() * z_j,
                             s.j.A.transpose() * u_j);
  return s;
}

std::vector<Freedom> freedoms(const std::string& type, const Placed& s) {
  const Vec none = Vec::Zero();
  const Freedom turn_z{none, s.z}, slide_z{s.z, none}, slide_u{s.u, none}, slide_v{s.v, none};
  const std::vector<Freedom> turn_all{{none, s.u}, {none, s.v}, turn_z};
  const auto with_turns = [&](std::vector<Freedom> f) {
    f.insert(f.end(), turn_all.begin(), turn_all.end());
    return f;
  };
  const Vec d = s.P_j - (s.i.r + s.i.A * s.fi.point);
  if (type == "spherical") return turn_all;
  if (type == "universal") return {turn_z, {none, s.j.A * s.fj.z}};
  if (type == "revolute") return {turn_z};
  if (type == "cylindrical") return {turn_z, slide_z};
  if (type == "translational") return {slide_z};
  if (type == "fixed") return {};
  if (type == "planar") return {turn_z, slide_u, slide_v};
  if (type == "in_line") return with_turns({slide_z});
  if (type == "in_plane") return with_turns({slide_u, slide_v});
  if (type == "distance") return with_turns({{d.cross(s.u), none}, {d.cross(s.v), none}});
  return {slide_u, slide_v, slide_z, {none, s.u}, {none, s.v}};  // rotation_driver: all but rotation about z
}

TEST(Joints, LeaveExactlyTheirFreedoms) {
  Random random(32);
  for (int n = 0; n < 20; ++n)
    for (const auto& [type, names] : expected_rows) {
      const Placed s = place(type, random);
      const auto rows = build(type, s.fi, s.fj, s.length, s.angle);
      MatrixX<double> Phi(rows.size(), 12);
      for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto row = evaluate_row(rows[k].constraint, s.i, s.j, 0.0);
        Phi.row(k) << row.r_i, row.rot_i, row.r_j, row.rot_j;
        EXPECT_NEAR(row.phi, 0, 1e-13) << type << " holds in its allowed position: " << rows[k].label;
      }
      // columns: six motions of both bodies as one rigid body, then the free motions of j
      const auto free = freedoms(type, s);
      MatrixX<double> motions = MatrixX<double>::Zero(12, 6 + free.size());
      for (int k = 0; k < 3; ++k) {
        const Vec e = Vec::Unit(k);
        motions.col(k) << e, Vec::Zero(), e, Vec::Zero();
        motions.col(3 + k) << e.cross(s.i.r), e, e.cross(s.j.r), e;
      }
      for (std::size_t k = 0; k < free.size(); ++k)
        motions.col(6 + k).tail<6>() << free[k].translation + free[k].rotation.cross(s.j.r - s.P_j),
            free[k].rotation;
      const auto rank = [](const MatrixX<double>& m) {
        Eigen::ColPivHouseholderQR<MatrixX<double>> qr(m);
        qr.setThreshold(1e-10);
        return qr.rank();
      };
      EXPECT_LE((Phi * motions).cwiseAbs().maxCoeff(), 1e-13) << type;
      EXPECT_EQ(rank(motions), motions.cols()) << type;
      EXPECT_EQ(rank(Phi), Phi.rows()) << type;
      EXPECT_EQ(Phi.rows() + motions.cols(), 12) << type << " has as many freedoms as rows leave";
    }
}

TEST(RotationDriver, TurnsWithItsAngle) {
  Random random(33);
  const TimeFunction alpha = TimeFunction::Polynomial{{0.3, 2.0, -0.7}};
  for (int n = 0; n < 30; ++n) {
    Placed s = place("revolute", random);
    const double t = random.uniform(-2, 2);
    const Jet<double> angle = alpha(t);
    // the angle from u_i to u_j is alpha, and j rotates relative to i with alpha'
    s.j.A = s.i.A * (Matrix3<double>() << s.fi.u, s.fi.v, s.fi.z).finished() * axis_rotation(2, angle.f) *
            (Matrix3<double>() << s.fj.u, s.fj.v, s.fj.z).finished().transpose();
    s.j.omega = s.i.omega + angle.f_t * (s.i.A * s.fi.z);
    const auto row = evaluate_row(build("rotation_driver", s.fi, s.fj, 1, alpha)[0].constraint, s.i, s.j, t);
    EXPECT_NEAR(row.phi, 0, 1e-14);
    EXPECT_NEAR(row.nu, angle.f_t, 1e-13);
    EXPECT_NEAR(row.rot_i.dot(s.i.omega) + row.rot_j.dot(s.j.omega), row.nu, 1e-13);
    // dPhi/dtheta = 1, so that lambda is a torque about z
    EXPECT_LE(distance(row.rot_j.transpose(), s.i.A * s.fi.z), 1e-14);
  }
}

}  // namespace
}  // namespace trivium
