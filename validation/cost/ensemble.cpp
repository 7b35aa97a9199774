/// Draws random states of an arm in portions that fit the clock's resolution. Every engine solves the same
/// portions, in random order.

#include "validation/cost/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <random>

#include "bodies/rotations/so3.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/make_mechanism.hpp"
#include "scenes/scene_state.hpp"
#include "validation/cost/peer_translation.hpp"
#include "validation/cost/quad_solution.hpp"
#include "validation/cost/state_sweep.hpp"
#include "validation/harness/timed_formulations.hpp"
#ifdef TRIVIUM_COST_MUJOCO
#include "validation/cost/mujoco_engine.hpp"
#endif

namespace trivium::cost {

namespace {

using V = trivium::Vector3<double>;

/// Number of states in a portion, chosen by experiment. Fewer states make the clock's resolution visible;
/// more leave fewer portions for the median.
constexpr int portion_size = 4000;
/// Number of states that are also solved in quad, whose errors are reported. 16 is a compromise: a solution
/// in quad takes much longer than one in double, and fewer states may miss the large errors.
constexpr int checked_states = 16;

scenes::Scene arm_under_gravity() {
  scenes::Scene arm = load_scene("open_arm_7", 0);
  std::erase_if(arm.effects,
                [](const scenes::Effect& e) { return !std::holds_alternative<Gravity<double>>(e); });
  return arm;
}

Matrix3<double> axes_of(const JointFrame<double>& frame) {
  Matrix3<double> axes;
  axes << frame.u, frame.v, frame.z;
  return axes;
}

/// An open chain. Each joint turns its body j relative to body i, which comes earlier in the list.
class Arm {
 public:
  explicit Arm(const scenes::Scene& scene)
      : mechanism(make_mechanism<double>(scene)), at_rest_(make_state<double>(scene, 0.0)) {}

  /// The angle [rad] of joint k in the state that the scene file states.
  double own_angle(std::size_t k) const {
    const Joint<double>& joint = mechanism.joints[k];
    const Matrix3<double> A_i = joint.i == mechanism.ground() ? Matrix3<double>(Matrix3<double>::Identity())
                                                              : rotation_matrix(at_rest_.pose[joint.i].p);
    const V u = A_i.transpose() * (rotation_matrix(at_rest_.pose[joint.j].p) * joint.frame_j.u);
    return std::atan2(joint.frame_i.v.dot(u), joint.frame_i.u.dot(u));
  }

  MechanismState<double> state(const std::vector<double>& angle, const std::vector<double>& rate) const {
    MechanismState<double> out = at_rest_;
    const Pose<double> ground_pose;
    for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
      const Joint<double>& joint = mechanism.joints[k];
      const bool on_ground = joint.i == mechanism.ground();
      const Pose<double>& inboard = on_ground ? ground_pose : out.pose[joint.i];
      const Matrix3<double> A_i = rotation_matrix(inboard.p);
      const V omega_i = on_ground ? V(V::Zero()) : V(A_i * out.twist[joint.i].omega_bar);
      const V r_dot_i = on_ground ? V(V::Zero()) : out.twist[joint.i].r_dot;
      const Matrix3<double> turn = Eigen::AngleAxisd(angle[k], V::UnitZ()).toRotationMatrix();
      const Matrix3<double> A = A_i * axes_of(joint.frame_i) * turn * axes_of(joint.frame_j).transpose();
      const Eigen::Quaterniond q(A);
      Pose<double>& pose = out.pose[joint.j];
      pose.p = Vector4<double>(q.w(), q.x(), q.y(), q.z()).normalized();
      const V arm_i = A_i * joint.frame_i.point, arm_j = A * joint.frame_j.point;
      const V omega = omega_i + rate[k] * (A_i * joint.frame_i.z);
      pose.r = inboard.r + arm_i - arm_j;
      out.twist[joint.j].omega_bar = A.transpose() * omega;
      out.twist[joint.j].r_dot = r_dot_i + omega_i.cross(arm_i) - omega.cross(arm_j);
    }
    return out;
  }

  Mechanism<double> mechanism;

 private:
  MechanismState<double> at_rest_;
};

/// Random states, in the coordinates of all engines: joint angles and rates, and Trivium's states.
struct Portion {
  std::vector<std::vector<double>> angles, rates;
  States states;
};

class Ensemble {
 public:
  const scenes::Scene scene = arm_under_gravity();
  const Arm arm{scene};

  Portion draw() {
    Portion portion;
    for (int n = 0; n < portion_size; ++n) {
      auto& angles = portion.angles.emplace_back();
      auto& rates = portion.rates.emplace_back();
      for (std::size_t k = 0; k < arm.mechanism.joints.size(); ++k) {
        angles.push_back(uniform(3));  // [rad]: nearly all angles
        rates.push_back(uniform(2));   // [rad/s], chosen by experiment
      }
      portion.states.push_back(arm.state(angles, rates));
    }
    return portion;
  }

  QuadSolution exact(const MechanismState<double>& state) const {
    scenes::Scene here = scene;
    set_state(here, state);
    return quad_solution(here);
  }

 private:
  /// A random number in [-size, size]. The 53 upper bits fill the significand of a double; the result is the
  /// same with every standard library.
  double uniform(double size) { return size * (2 * static_cast<double>(engine_() >> 11) * 0x1.0p-53 - 1); }

  std::mt19937_64 engine_{7};
};

/// One engine, which solves all states of a portion.
struct Sweep {
  Measurement row;
  std::function<void(const Portion&)> take;
  std::function<void()> all;
  std::function<std::vector<Vector3>(int)> r_ddot;
  std::vector<double> seconds;  ///< CPU time of each portion [s]
};

Sweep our_sweep(const Measurement& row, const StateSweep& sweep) {
  return {row,
          [take = sweep.take](const Portion& portion) { take(portion.states); },
          sweep.all,
          sweep.r_ddot,
          {}};
}

#ifdef TRIVIUM_COST_MUJOCO
Sweep mujoco_sweep(const Ensemble& ensemble, Measurement row) {
  struct Data {
    std::unique_ptr<MujocoEngine> engine;
    std::vector<std::vector<double>> qpos, qvel;
    void evaluate(std::size_t n) const {
      engine->set_state(qpos[n], qvel[n]);
      engine->evaluate();
    }
  };
  auto data = std::make_shared<Data>();
  data->engine = mujoco_engine_with_states(to_peers(ensemble.scene));
  row.engine = mujoco_name;
  return {row,
          [data, &arm = ensemble.arm](const Portion& portion) {
            data->qvel = portion.rates;
            data->qpos = portion.angles;
            for (auto& qpos : data->qpos)
              for (std::size_t k = 0; k < qpos.size(); ++k) qpos[k] -= arm.own_angle(k);
          },
          [data] {
            for (std::size_t n = 0; n < data->qpos.size(); ++n) data->evaluate(n);
          },
          [data](int n) {
            data->evaluate(static_cast<std::size_t>(n));
            return data->engine->r_ddot();
          },
          {}};
}
#endif

std::vector<Sweep> sweeps(const Ensemble& ensemble, int states) {
  Measurement row;
  row.scene = row.family = "ensemble";
  row.n = states;
  row.bodies = ensemble.arm.mechanism.nb();
  std::vector<Sweep> all;
  const Mechanism<double>& mechanism = ensemble.arm.mechanism;
  for (const Refined refined : {Refined::no, Refined::yes}) {
    for (const std::string& formulation : TimedFormulations::names())
      all.push_back(
          our_sweep(of_ours(row, formulation, refined), one_by_one(mechanism, formulation, refined)));
    for (const std::string& formulation : TimedFormulations::names()) {
      Measurement batches = of_ours(row, formulation, refined);
      batches.engine += fmt::format(", {} lanes", register_lanes);
      all.push_back(our_sweep(batches, in_batches(mechanism, formulation, refined)));
    }
  }
#ifdef TRIVIUM_COST_MUJOCO
  all.push_back(mujoco_sweep(ensemble, row));
#endif
  return all;
}

double median(std::vector<double> x) {
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::nth_element(x.begin(), middle, x.end());
  return *middle;
}

}  // namespace

std::vector<Measurement> measure_ensemble(int states) {
  Ensemble ensemble;
  std::vector<Sweep> all = sweeps(ensemble, states);
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937_64 engine(1);
  for (int done = 0; done < states; done += portion_size) {
    const Portion portion = ensemble.draw();
    for (Sweep& sweep : all) sweep.take(portion);
    if (done == 0)
      for (int n = 0; n < checked_states; ++n) {
        const QuadSolution exact = ensemble.exact(portion.states[static_cast<std::size_t>(n)]);
        for (Sweep& sweep : all) {
          const double error = exact.error_of(sweep.r_ddot(n)), worst = sweep.row.error.value_or(0);
          sweep.row.error = error <= worst || std::isnan(worst) ? worst : error;  // once NaN, always NaN
        }
      }
    std::shuffle(order.begin(), order.end(), engine);
    for (const std::size_t k : order) all[k].seconds.push_back(seconds_of(all[k].all));
  }
  std::vector<Measurement> rows;
  for (Sweep& sweep : all) {
    sweep.row.microseconds = 1e6 * median(sweep.seconds) / portion_size;
    rows.push_back(sweep.row);
  }
  set_ratios(rows);
  return rows;
}

}  // namespace trivium::cost
