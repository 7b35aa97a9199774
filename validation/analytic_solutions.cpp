/// Does a motion meet the solutions that are known in closed form, and the curves of an independent code?
/// Every problem in every formulation, by Fehlberg's method at tight tolerance; the largest error of each
/// quantity over the run, and what it is held to.

#include <fmt/format.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <tuple>

#include "base/json_writer.hpp"
#include "base/progress.hpp"
#include "base/table.hpp"
#include "bodies/rotations/so3.hpp"
#include "formulations/r_omega.hpp"
#include "formulations/side_by_side.hpp"
#include "formulations/structured/acceleration_solver.hpp"
#include "scenes/make_mechanism.hpp"
#include "simulation/simulate.hpp"
#include "validation/harness/program.hpp"
#include "validation/harness/trusted_numbers.hpp"

namespace trivium {

namespace {

using Vector = Vector3<double>;
const double pi = std::acos(-1.0);

struct Check {
  std::string problem, formulation, quantity;
  double error, bound;
  bool passed() const { return error <= bound; }
};

/// What a problem is compared in, one after the other.
class Errors {
 public:
  void raise(const std::string& quantity, double error, double bound) {
    for (Check& c : checks_)
      if (c.quantity == quantity) {
        if (!(error <= c.error)) c.error = error;
        return;
      }
    checks_.push_back({"", "", quantity, error, bound});
  }
  std::vector<Check> checks_;
};

std::vector<MotionSample> motion(const scenes::Scene& scene, const std::string& formulation, double end,
                                 double output_step) {
  Samples samples;
  SimulationOptions options;
  options.formulation = formulation;
  options.integrator = "rkf78";
  options.end = end;
  options.output_step = output_step;
  options.tolerances = {1e-12, 1e-14};
  simulate(make_model<double>(scene), options, samples);
  return samples.all;
}

scenes::Scene catalogue_scene(const std::string& name) { return load_scene(name, 0); }
Vector vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// The angle from the vertical of a pendulum released from the horizontal: sin(theta / 2) = k cd(omega t),
/// k^2 = 1/2.
double released_angle(double omega, double t) {
  const double k = std::sqrt(0.5);
  double cn, dn;
  boost::math::jacobi_elliptic(k, omega * t, &cn, &dn);
  return 2 * std::asin(k * cn / dn);
}

// the problems

void pendulum(const std::string& formulation, Errors& errors) {
  const double g = 9.81;
  for (const MotionSample& s : motion(catalogue_scene("a01_pendulum"), formulation, 10, 0.1)) {
    const double theta = released_angle(std::sqrt(g), s.state.t);
    const Vector exact(-std::sin(theta), -std::cos(theta), 0);
    errors.raise("position [m]", (s.state.pose[0].r - exact).norm(), 1e-10);
    errors.raise("tension [N]", std::abs(s.reactions[0].force.norm() - 3 * g * std::cos(theta)), 1e-8);
  }
}

/// A body on a revolute, or on a universal joint that it turns in about one axis, released from the
/// horizontal; `side` is where its centre was then.
void physical_pendulum(const std::string& name, const Vector& side, const std::string& formulation,
                       Errors& errors) {
  const double m = 1, l = 2, J = 0.1, g = 9.80665, omega2 = m * g * l / (J + m * l * l);
  const Vector up(0, 0, 1);
  for (const MotionSample& s : motion(catalogue_scene(name), formulation, 5, 0.1)) {
    const double theta = released_angle(std::sqrt(omega2), s.state.t);
    const Vector out = std::sin(theta) * side - std::cos(theta) * up,
                 along = std::cos(theta) * side + std::sin(theta) * up;
    // theta'^2 = 2 omega^2 cos(theta), theta'' = -omega^2 sin(theta)
    const Vector a = l * (-omega2 * std::sin(theta) * along - 2 * omega2 * std::cos(theta) * out);
    errors.raise("position [m]", (s.state.pose[0].r - l * out).norm(), 1e-10);
    errors.raise("reaction [N]", (s.reactions[0].force - m * (a + g * up)).norm(), 1e-8);
  }
}

/// Euler's equations without moments: omega_bar = (s1 a1 cn, s2 a2 sn, s3 a3 dn) of p t + u0 (Landau and
/// Lifshitz, Mechanics, paragraph 37), or with 1 and 3 changed where the energy is that of the other kind.
void free_body(const std::string& name, const std::string& formulation, Errors& errors) {
  const scenes::Scene scene = catalogue_scene(name);
  const auto& diagonal = std::get<scenes::Vector3>(scene.bodies[0].inertia);
  Vector J = vector(diagonal), w = vector(scene.bodies[0].angular_velocity);
  const double twice_T = w.dot(J.cwiseProduct(w)), L2 = J.cwiseProduct(w).squaredNorm();
  const bool is_other = L2 < twice_T * J[1];
  if (is_other) {
    std::swap(J[0], J[2]);
    std::swap(w[0], w[2]);
  }
  const double sign = is_other ? -1 : 1;  // of the differences of moments
  const double a1 = std::sqrt((twice_T * J[2] - L2) / (J[0] * (J[2] - J[0]))),
               a2 = std::sqrt((twice_T * J[2] - L2) / (J[1] * (J[2] - J[1]))),
               a3 = std::sqrt((L2 - twice_T * J[0]) / (J[2] * (J[2] - J[0]))),
               p = std::sqrt((J[2] - J[1]) * (L2 - twice_T * J[0]) / (J[0] * J[1] * J[2])),
               k = std::sqrt((J[1] - J[0]) * (twice_T * J[2] - L2) / ((J[2] - J[1]) * (L2 - twice_T * J[0])));
  const double s3 = w[2] < 0 ? -1 : 1, s2 = 1, s1 = sign * s2 * s3;
  const double u0 = boost::math::ellint_1(k, std::atan2(s2 * w[1] / a2, s1 * w[0] / a1));
  for (const MotionSample& s : motion(scene, formulation, 20, 0.25)) {
    double cn, dn;
    const double sn = boost::math::jacobi_elliptic(k, p * s.state.t + u0, &cn, &dn);
    Vector exact(s1 * a1 * cn, s2 * a2 * sn, s3 * a3 * dn);
    if (is_other) std::swap(exact[0], exact[2]);
    errors.raise("omega_bar [rad/s]", (s.state.twist[0].omega_bar - exact).norm(), 1e-9);
  }
}

/// The axis nutates with the period of its elliptic functions.
void heavy_top(const std::string& formulation, Errors& errors) {
  constexpr double period = 0.74520694761676905573;
  const scenes::Scene scene = catalogue_scene("heavy_top");
  for (const double t : {0.1, 0.2, 0.3}) {
    const MotionSample first = motion(scene, formulation, t, t).back(),
                       again = motion(scene, formulation, t + period, t + period).back();
    errors.raise("height after a nutation [m]", std::abs(first.state.pose[0].r[2] - again.state.pose[0].r[2]),
                 1e-9);
    errors.raise("spin [rad/s]", std::abs(again.state.twist[0].omega_bar[1] - 150), 1e-9);
  }
}

/// The same top where it precesses evenly: horizontal, Omega = m g l / (J n).
void steady_precession(const std::string& formulation, Errors& errors) {
  scenes::Scene scene = catalogue_scene("heavy_top");
  const double n = 150, Omega = 15 * 9.81 / (0.46875 * n);
  scene.bodies[0].angular_velocity = {0, n, Omega};
  scene.bodies[0].velocity = {-Omega, 0, 0};
  for (const MotionSample& s : motion(scene, formulation, 2, 0.1)) {
    const double phi = Omega * s.state.t;
    const Vector r(-std::sin(phi), std::cos(phi), 0);
    errors.raise("position [m]", (s.state.pose[0].r - r).norm(), 1e-9);
    errors.raise("reaction [N]",
                 (s.reactions[0].force - 15 * (Vector(0, 0, 9.81) - Omega * Omega * r)).norm(), 1e-5);
  }
}

/// All rods of the four-bars turn by one angle, which is that of a pendulum that goes round: psi / 2 =
/// am(...).
void four_bars(const std::string& formulation, Errors& errors) {
  const int loops = 2;
  const double inertia = (loops + 1) / 3.0 + loops, weight = 9.81 * ((loops + 1) / 2.0 + loops),
               a = weight / inertia, k = std::sqrt(4 * a / (1 + 4 * a)), rate = std::sqrt(1 + 4 * a) / 2,
               K = boost::math::ellint_1(k);
  for (const MotionSample& s : motion(catalogue_scene("n_four_bar_2"), formulation, 10, 0.25)) {
    double cn, dn;
    const double sn = boost::math::jacobi_elliptic(k, rate * s.state.t - K, &cn, &dn);
    // psi from the lowest position; the rods' angle from the upright one is psi + pi
    const double sin_psi = 2 * sn * cn, cos_psi = 1 - 2 * sn * sn;
    const Vector exact(loops - 0.5 - sin_psi, -cos_psi, 0);
    errors.raise("position [m]", (s.state.pose.back().r - exact).norm(), 1e-6);
  }
}

/// Position, velocity, acceleration, orientation, angular velocity and acceleration, and the joint's force
/// and torque on the ground, as MSC ADAMS has them: to about 5e-6 m, on the universal joint to 1e-3 m, as the
/// exact motions of the same pendulums show. `looser`: how much more is granted there.
void adams(const std::string& name, double looser, const std::string& formulation, Errors& errors) {
  const Reference file(reference_directory(), name);
  const scenes::Scene scene = catalogue_scene(name);
  const auto mechanism = make_mechanism<double>(scene);
  AccelerationSolver<ROmega<double>> solver(mechanism);
  const std::vector<MotionSample> samples = motion(scene, formulation, 5, 0.1);
  const auto column = [&](const std::string& stem, std::size_t row) {
    return Vector(file[stem + "x"][row], file[stem + "y"][row], file[stem + "z"][row]);
  };
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const MotionSample& s = samples[k];
    const Pose<double>& pose = s.state.pose[0];
    const Matrix3<double> A = rotation_matrix(pose.p);
    solver.solve(to_coordinates<ROmega<double>>(mechanism, s.state, {}), s.state.t);
    const Vector4<double> p(file["e0"][k], file["e1"][k], file["e2"][k], file["e3"][k]);
    errors.raise("position [m]", (pose.r - column("", k)).norm(), 1e-4 * looser);
    errors.raise("velocity [m/s]", (s.state.twist[0].r_dot - column("v", k)).norm(), 2e-4 * looser);
    errors.raise("acceleration [m/s^2]", (solver.r_ddot(0) - column("a", k)).norm(), 1e-3 * looser);
    errors.raise("orientation [rad]", 2 * std::min((pose.p - p).norm(), (pose.p + p).norm()), 1e-4 * looser);
    errors.raise("angular velocity [rad/s]", (A * s.state.twist[0].omega_bar - column("w", k)).norm(),
                 1e-4 * looser);
    errors.raise("angular acceleration [rad/s^2]", (A * solver.omega_bar_dot(0) - column("alpha", k)).norm(),
                 1e-3 * looser);
    errors.raise("force [N]", (-s.reactions[0].force - column("f", k)).norm(), 1e-3 * looser);
    errors.raise("torque [N m]", (-s.reactions[0].torque - column("t", k)).norm(), 1e-3);
  }
}

struct Problem {
  std::string name;
  std::function<void(const std::string&, Errors&)> compare;
};

std::vector<Problem> problems() {
  std::vector<Problem> all{{"pendulum", pendulum},
                           {"heavy_top", heavy_top},
                           {"steady_precession", steady_precession},
                           {"four_bars", four_bars}};
  for (const auto& [problem, name, side] :
       {std::tuple("pendulum_on_a_revolute", "adams_revolute_case01", Vector(1, 0, 0)),
        {"pendulum_on_a_universal", "adams_universal_case01", Vector(0, 1, 0)}})
    all.push_back({problem, [name = name, side = side](const std::string& f, Errors& e) {
                     physical_pendulum(name, side, f, e);
                   }});
  for (const char* name : {"asymmetric_free_body", "dzhanibekov"})
    all.push_back({name, [name](const std::string& f, Errors& e) { free_body(name, f, e); }});
  for (const auto& [name, looser] : {std::pair("adams_revolute_case01", 1.0),
                                     {"adams_spherical_case02", 1.0},
                                     {"adams_universal_case01", 20.0}})
    all.push_back({name, [name = name, looser = looser](const std::string& f, Errors& e) {
                     adams(name, looser, f, e);
                   }});
  return all;
}

std::string text(const std::vector<Check>& checks) {
  Table table({"problem", "quantity", "r-omega", "r-p", "r-epsilon", "omega-first", "bound", "verdict"});
  const std::size_t n = formulation_names().size();
  for (std::size_t first = 0; first < checks.size(); first += n) {
    std::vector<std::string> row{checks[first].problem, checks[first].quantity};
    bool passed = true;
    for (std::size_t k = first; k < first + n; ++k) {
      row.push_back(fmt::format("{:.1e}", checks[k].error));
      passed = passed && checks[k].passed();
    }
    row.push_back(fmt::format("{:.0e}", checks[first].bound));
    row.push_back(passed ? "ok" : "EXCEEDS");
    table.add(row);
  }
  return table.text();
}

std::string json(const std::vector<Check>& checks, bool passed) {
  JsonWriter out;
  out.begin_object().flag("passed", passed).begin_array("checks");
  for (const Check& c : checks)
    out.begin_object()
        .text("problem", c.problem)
        .text("formulation", c.formulation)
        .text("quantity", c.quantity)
        .number("error", c.error)
        .number("bound", c.bound)
        .flag("passed", c.passed())
        .end_object();
  return out.end_array().end_object().str();
}

int run(const Program& program) {
  const std::vector<Problem> all = problems();
  const std::vector<std::string> formulations = formulation_names();
  std::vector<Check> checks;
  Progress progress("analytic_solutions", all.size() * formulations.size());
  for (const Problem& problem : all) {
    std::vector<Errors> errors(formulations.size());
    for (std::size_t f = 0; f < formulations.size(); ++f) {
      problem.compare(formulations[f], errors[f]);
      progress.step();
    }
    for (std::size_t q = 0; q < errors[0].checks_.size(); ++q)
      for (std::size_t f = 0; f < formulations.size(); ++f) {
        Check check = errors[f].checks_[q];
        check.problem = problem.name;
        check.formulation = formulations[f];
        checks.push_back(check);
      }
  }
  const bool passed = std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.passed(); });
  ResultsFile file("analytic_solutions", {"problem", "formulation", "quantity", "error", "bound", "verdict"});
  for (const Check& c : checks)
    file.add({c.problem, c.formulation, c.quantity, results_number(c.error), results_number(c.bound),
              c.passed() ? "ok" : "EXCEEDS"});
  program.write(file);
  fmt::print("{}", program.json() ? json(checks, passed) : text(checks));
  return batch_exit(true, passed);
}

}  // namespace

}  // namespace trivium

int main(int argc, char** argv) {
  using namespace trivium;
  Program program(
      "Does a motion meet the solutions that are known in closed form, and an independent code's curves?",
      "analytic_solutions", "the problems themselves");
  return program.run(argc, argv, [&] { return run(program); });
}
