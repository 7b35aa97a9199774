/// Draws bodies first and fits joints between them: a tree, then closings, repeated joints, nearly dependent
/// rows and a driver on request, and effects.

#include "formulations/testing/random_mechanism.hpp"

#include "bodies/rotations/so3.hpp"
#include "bodies/testing/properties.hpp"
#include "bodies/testing/random.hpp"
#include "formulations/analysis/assemble.hpp"
#include "formulations/side_by_side.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/scene_state.hpp"
#include "scenes/testing/scene_builders.hpp"

namespace trivium::test {

namespace {

using Vec = Vector3<double>;
using TF = TimeFunction;

scenes::Vector3 store(const Vec& v) { return {v[0], v[1], v[2]}; }

/// The points and axes of a joint on both bodies, global.
struct GlobalJoint {
  Vec P_i, P_j, z_i, z_j, u_i, u_j;
};

class SceneBuilder {
 public:
  SceneBuilder(std::uint64_t seed, const MechanismOptions& options) : random_(seed), options_(options) {}

  scenes::Scene build() {
    for (int b = 0; b < options_.bodies; ++b) add_body(b);
    for (int b = 0; b < options_.bodies; ++b) {
      const int parent = random_.index(b + 1) - 1;
      add_joint(draw_type(), parent, b);
    }
    for (int k = 0; k < options_.closings; ++k) add_closing();
    for (int k = 0; k < options_.doubled; ++k) double_a_joint();
    if (options_.near_rows > 0) add_near_rows();
    if (options_.driven) drive_a_revolute();
    add_effects();
    project_velocities(scene_);
    return scene_;
  }

 private:
  void add_body(int b) {
    scenes::Body body;
    body.name = "body " + std::to_string(b);
    body.mass = std::pow(10.0, random_.uniform(-options_.mass_decades, options_.mass_decades));
    const double x = random_.uniform(0.5, 1.5), y = random_.uniform(0.5, 1.5), z = random_.uniform(0.5, 1.5);
    const double size = 0.1 * body.mass;  // moments of a box satisfy the triangle inequality
    body.inertia = scenes::Vector3{size * (y + z), size * (z + x), size * (x + y)};
    body.position = store(random_.vector<double, 3>());
    const Vector4<double> p = random_.euler_parameters<double>();
    body.orientation = scenes::EulerParameters{{p[0], p[1], p[2], p[3]}};
    if (options_.gimbal_distance > 0)
      body.orientation =
          scenes::EulerAngles{{random_.uniform(-3, 3), options_.gimbal_distance, random_.uniform(-3, 3)},
                              EulerSequence{{2, 0, 2}}};
    body.velocity = store(random_.vector<double, 3>());
    body.angular_velocity = store(random_.vector<double, 3>(2));
    scene_.bodies.push_back(body);
  }

  ConstraintType draw_type() {
    constexpr std::array types{JointType::spherical, JointType::universal,   JointType::revolute,
                               JointType::revolute,  JointType::cylindrical, JointType::translational,
                               JointType::planar,    JointType::in_line,     JointType::distance,
                               JointType::fixed};
    return types[random_.index(static_cast<int>(types.size()))];
  }

  GlobalJoint draw_geometry(ConstraintType type) {
    GlobalJoint g;
    g.z_i = g.z_j = random_.direction<double>();
    const JointFrame<double> axes = joint_frame<double>(Vec::Zero(), g.z_i, random_.direction<double>());
    g.u_i = g.u_j = axes.u;
    g.P_i = g.P_j = random_.vector<double, 3>();
    const Vec along = random_.uniform() * g.z_i;
    const double y = random_.uniform(), x = random_.uniform();
    const Vec across = x * axes.u + y * axes.v;
    using enum JointType;
    if (type == cylindrical || type == translational || type == in_line) g.P_j += along;
    if (type == planar) g.P_j += across;
    if (type == distance) g.P_j += along + across;
    if (type == universal) g.z_j = axes.u;
    if (type == universal) g.u_j = axes.v;
    return g;
  }

  scenes::Side side(int body, const Vec& P, const Vec& z, const Vec& u) const {
    const auto [r, A] = pose(body);
    return {body, store(A.transpose() * (P - r)), {}, store(A.transpose() * z), store(A.transpose() * u)};
  }
  std::pair<Vec, Matrix3<double>> pose(int body) const {
    if (body == scenes::ground) return {Vec::Zero(), Matrix3<double>::Identity()};
    const auto& b = scene_.bodies[body];
    return {Vec(b.position[0], b.position[1], b.position[2]),
            rotation_matrix(euler_parameters_of<double>(b.orientation))};
  }

  void add(ConstraintType type, int i, int j, const GlobalJoint& g) {
    scenes::Constraint c;
    c.type = type;
    c.name = "joint " + std::to_string(scene_.constraints.size());
    c.i = side(i, g.P_i, g.z_i, g.u_i);
    c.j = side(j, g.P_j, g.z_j, g.u_j);
    c.distance = (g.P_j - g.P_i).norm();
    scene_.constraints.push_back(c);
    geometry_.push_back(g);
  }
  void add_joint(ConstraintType type, int i, int j) { add(type, i, j, draw_geometry(type)); }

  /// Adds one basic row between two bodies, drawn again until it is independent of the others.
  void add_closing() {
    for (int attempt = 0; attempt < 20; ++attempt) {
      const int j = random_.index(options_.bodies), i = random_.index(options_.bodies + 1) - 1;
      scenes::Constraint c;
      constexpr std::array types{basic_type<DP1>, basic_type<DP2>, basic_type<D>, basic_type<CD>};
      c.type = types[random_.index(4)];
      c.name = "closing " + std::to_string(scene_.constraints.size());
      const auto draw = [&] { return store(random_.vector<double, 3>()); };
      c.i = {i, draw(), draw(), {}, {}};
      c.j = {j, draw(), draw(), {}, {}};
      c.direction = draw();
      add_fitted(c);
      if (i != j && is_independent()) return;
      remove_last();
    }
  }
  bool is_independent() const {
    const auto system = tangent_system(make_mechanism<double>(scene_), make_state<double>(scene_));
    return analyse_rows(system).dependent.empty();
  }
  void remove_last() {
    scene_.constraints.pop_back();
    geometry_.pop_back();
  }

  /// Adds two distance rows whose points on body j differ by about near_rows.
  void add_near_rows() {
    const int j = random_.index(options_.bodies);
    const Vec s_i = random_.vector<double, 3>(3), s_j = random_.vector<double, 3>();
    for (const double shift : {0.0, options_.near_rows}) {
      scenes::Constraint c;
      c.type = basic_type<D>;
      c.name = "near " + std::to_string(scene_.constraints.size());
      c.i = test::side(scenes::ground, store(s_i));
      c.j = test::side(j, store(s_j + shift * Vec(0.3, -0.5, 0.8)));
      add_fitted(c);
      if (!is_independent()) return remove_last();
    }
  }

  /// Adds a row with f(0) set such that Phi = 0 at the poses.
  void add_fitted(const scenes::Constraint& c) {
    scene_.constraints.push_back(c);
    geometry_.emplace_back();
    const auto mechanism = make_mechanism<double>(scene_);
    const auto eom = equations_of_motion<ROmega<double>>(
        mechanism, to_coordinates<ROmega<double>>(mechanism, make_state<double>(scene_), {}), 0.0);
    const double phi = eom.row.back().phi;
    scene_.constraints.back().f =
        options_.driven ? TF(TF::Polynomial{{phi, random_.uniform(), random_.uniform()}}) : TF(phi);
  }

  /// Repeats a joint, a revolute or cylindrical one at another point of its axis: every row of the second
  /// joint is redundant.
  void double_a_joint() {
    const std::size_t k = random_.index(options_.bodies);
    const scenes::Constraint first = scene_.constraints[k];
    GlobalJoint g = geometry_[k];
    if (properties_of(first.type).has_an_angle) {
      g.P_i += 0.5 * g.z_i;
      g.P_j += 0.5 * g.z_i;
    }
    add(first.type, first.i.body, first.j.body, g);
  }

  void drive_a_revolute() {
    for (std::size_t k = 0; k < scene_.constraints.size(); ++k) {
      if (scene_.constraints[k].type != JointType::revolute) continue;
      const auto [i, j] = std::pair{scene_.constraints[k].i.body, scene_.constraints[k].j.body};
      add(JointType::rotation_driver, i, j, geometry_[k]);
      scene_.constraints.back().angle = TF::Polynomial{{0, random_.uniform(), random_.uniform()}};
      if (!is_independent()) remove_last();
      return;
    }
  }

  void add_effects() {
    scene_.effects.push_back(Gravity<double>{"", {0.3, -0.4, -9.81}});
    const auto functions = [&] {
      return std::array<TF, 3>{TF(random_.uniform(-5, 5)), TF(random_.uniform(-5, 5)),
                               TF(TF::Harmonic{0, random_.uniform(-5, 5), 3, 1})};
    };
    const int last = options_.bodies - 1;
    scene_.effects.push_back(
        Force<double>{"", 0, random_.vector<double, 3>(), functions(), ComponentFrame::body});
    scene_.effects.push_back(Torque<double>{"", last, functions(), ComponentFrame::global});
    SpringDamper<double> spring;
    spring.i = {scenes::ground, random_.vector<double, 3>(3)};
    spring.j = {last, random_.vector<double, 3>()};
    spring.stiffness = 20;
    spring.damping = 3;
    spring.free_length = 0.5;
    scene_.effects.push_back(spring);
  }

  Random random_;
  MechanismOptions options_;
  scenes::Scene scene_;
  std::vector<GlobalJoint> geometry_;
};

}  // namespace

scenes::Scene random_scene(std::uint64_t seed, const MechanismOptions& options) {
  return SceneBuilder(seed, options).build();
}

void project_velocities(scenes::Scene& scene) {
  auto [mechanism, state] = make_model<double>(scene);
  trivium::project_velocities(mechanism, state);
  set_state(scene, state);
}

}  // namespace trivium::test
