#pragma once
/// Measures how far a state violates its constraints. integrators/projection_iteration.hpp decides by the
/// relative measure.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/raise.hpp"
#include "formulations/structured/connected_bodies.hpp"
#include "formulations/structured/graph_solver.hpp"
#include "integrators/contract/first_order_system.hpp"

namespace trivium {

/// The absolute measure of a violation is the largest |Phi_k| or |Phi_k'| divided by the row's scale [m or
/// rad, m/s or rad/s]. The relative measure [-] divides further by the size of the component, which is the
/// set of bodies connected by rows. For a row of lengths this size is the bound of the distance of the
/// component's points from the origin, and for Phi_k' a bound of the speed of its points. For a row of angles
/// it is 1, and for Phi_k' a bound of its angular velocity. Both speeds are at least a thousandth of the
/// largest so far (move). The relative violation caused by rounding is then a few u, whatever the size of the
/// mechanism.
template <class S>
class ConstraintViolation {
 public:
  /// The mechanism and the graph must outlive this object. `t` is the time at which row scales are taken [s].
  template <class Types>
  ConstraintViolation(const Mechanism<S, Types>&, const BodyJointGraph&&, const S&) = delete;
  template <class Types>
  ConstraintViolation(const Mechanism<S, Types>& mechanism, const BodyJointGraph& graph, const S& t)
      : nb_(mechanism.nb()),
        row_names_(mechanism.row_names),
        graph_(graph),
        scale_(graph.edges.size()),
        turns_(graph.edges.size()),
        component_(components_of(graph)),
        extent_(component_.size()) {
    measure_reaches(mechanism.joints);
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      scale_[e].setOnes();
      if (graph.edges[e].is_soft) continue;
      for (int k = 0; k < graph.edges[e].size(); ++k) {
        const auto& row = mechanism.rows[graph.edges[e].rows[k]];
        scale_[e][k] = row_scale(row, t);
        turns_[e][k] = is_of_angle(row);
      }
    }
  }

  /// Measures the sizes of all components for the given body states.
  template <class Body>
  void move(const std::vector<Body>& body) {
    for (Extent& extent : extent_) {
      extent.length = S(0);
      // A component that is momentarily at rest has velocities of rounding size. The scale therefore stays at
      // a thousandth of its fastest speed so far. The factor is chosen by experiment: a smaller share takes
      // rounding for a violation, a larger one measures slow phases of a motion too loosely.
      extent.speed = extent.fastest / 1000;
      extent.spin = extent.fastest_spin / 1000;
    }
    for (int b = 0; b < nb_; ++b) {
      Extent& extent = extent_[component_[b]];
      // std::max may drop a NaN; the rows of such a body are NaN themselves, and so is their violation
      extent.length = std::max(extent.length, S(body[b].r.norm() + extent.reach));
      const S v = body[b].r_dot.norm(), omega = body[b].omega_bar.norm();
      extent.speed = std::max(extent.speed, S(v + omega * extent.reach));
      // A speed v has the rounding error u v. At a joint this error acts as an angular velocity of u v / arm,
      // also if the body does not rotate. The scale of angular velocities must therefore be at least v / arm.
      extent.spin = std::max(extent.spin, extent.arm > S(0) ? S(omega + v / extent.arm) : S(omega + v));
    }
  }
  /// The largest speeds so far, two per component [m/s, rad/s], for a saved run.
  std::vector<double> fastest() const {
    std::vector<double> speeds;
    for (const Extent& extent : extent_)
      speeds.insert(speeds.end(),
                    {static_cast<double>(extent.fastest), static_cast<double>(extent.fastest_spin)});
    return speeds;
  }
  /// Restores the speeds of a saved run. Returns false if their number does not fit.
  bool set_fastest(const std::vector<double>& speeds) {
    if (speeds.size() != 2 * extent_.size()) return false;
    for (std::size_t k = 0; k < extent_.size(); ++k) {
      extent_[k].fastest = S(speeds[2 * k]);
      extent_[k].fastest_spin = S(speeds[2 * k + 1]);
    }
    return true;
  }
  /// The motion has reached the state given to `move`: its speeds count among the fastest. So does
  /// sqrt(W / m) for each body of mass m, where W is the work of its loads over the length of its component
  /// and over 1 rad: this is the order of the speed that the body would reach if it were free. A component
  /// that its constraints lock would otherwise have no scale but the rounding of its velocities.
  void accept_state(const std::vector<RigidBody<S>>& bodies, const std::vector<Wrench<S>>& loads) {
    using std::sqrt;
    for (int b = 0; b < nb_; ++b) {
      Extent& extent = extent_[component_[b]];
      const S& mass = bodies[b].mass;
      S work = loads[b].F.norm() * extent.length + loads[b].n_bar.norm();  // over the length, or over 1 rad
      if (!(work > S(0)) || !(mass > S(0))) continue;
      const S fall = sqrt(work / mass);
      raise(extent.fastest, fall);
      raise(extent.fastest_spin, extent.arm > S(0) ? S(fall / extent.arm) : fall);
    }
    for (Extent& extent : extent_) {
      raise(extent.fastest, extent.speed);
      raise(extent.fastest_spin, extent.spin);
    }
  }
  /// Takes over the fastest speeds of another measure of the same mechanism.
  void take_fastest(const ConstraintViolation& other) {
    for (std::size_t k = 0; k < extent_.size(); ++k) {
      extent_[k].fastest = other.extent_[k].fastest;
      extent_[k].fastest_spin = other.extent_[k].fastest_spin;
    }
  }

  /// The largest violation of a row, from the values Phi of all rows.
  integrators::Violation<S> measure_positions(const GraphVector<S>& phi) const {
    return largest(phi, [](const Extent& of, bool is_turn) { return is_turn ? S(1) : of.length; });
  }
  /// The same from the values Phi' of all rows.
  integrators::Violation<S> measure_velocities(const GraphVector<S>& phi_dot) const {
    return largest(phi_dot, [](const Extent& of, bool is_turn) { return is_turn ? of.spin : of.speed; });
  }
  /// The name of a row; "none" for a negative number, which means that there are no rows.
  const std::string& row_name(int row) const {
    static const std::string none = "none";
    return row < 0 ? none : row_names_[row];
  }

  /// The number of a body's component, below nb. Rows connect bodies, but not through the ground.
  int component_of(int body) const { return component_[body]; }
  /// The largest distance of a joint's point from the centre of its body, in the component of a body [m].
  /// Points on the ground do not count.
  const S& arm_of(int body) const { return extent_[component_[body]].arm; }
  /// The fastest speed so far of a body's component [m/s].
  const S& fastest_of(int body) const { return extent_[component_[body]].fastest; }
  /// A bound of the distance of the component's points from the global origin [m].
  const S& length_of(int body) const { return extent_[component_[body]].length; }

 private:
  /// The size of a component: lengths [m], speeds [m/s], angular velocities [rad/s], the fastest so far.
  struct Extent {
    S arm{0}, reach{0};  ///< largest |joint point| in its frame [m]; `arm` leaves out the ground
    S length{0}, speed{0}, fastest{0}, spin{0}, fastest_spin{0};
  };

  void measure_reaches(const std::vector<Joint<S>>& joints) {
    for (const Joint<S>& joint : joints) {
      Extent& extent = extent_[component_[joint.i == nb_ ? joint.j : joint.i]];
      for (const auto& [body, point] :
           {std::pair(joint.i, joint.frame_i.point), {joint.j, joint.frame_j.point}}) {
        raise(extent.reach, S(point.norm()));
        if (body != nb_) raise(extent.arm, S(point.norm()));
      }
    }
  }

  template <class Size>
  integrators::Violation<S> largest(const GraphVector<S>& values, const Size& size_of) const {
    using std::abs;
    integrators::Violation<S> most;
    for (std::size_t e = 0; e < values.edge.size(); ++e) {
      const GraphEdge& edge = graph_.edges[e];
      if (edge.is_soft) continue;
      const Extent& extent = extent_[component_[edge.i == nb_ ? edge.j : edge.i]];
      for (int k = 0; k < edge.size(); ++k) {
        const S size = abs(values.edge[e][k]) / scale_[e][k], made_of = size_of(extent, turns_[e][k]);
        raise(most.size, size);
        if (!(size <= most.relative * made_of) && most.relative == most.relative) {
          most.relative = made_of > S(0) ? S(size / made_of) : size;  // a NaN is taken, and then kept
          most.row = edge.rows[k];
        }
        if (most.row < 0) most.row = edge.rows[k];
      }
    }
    return most;
  }

  const int nb_;
  const std::vector<std::string>& row_names_;
  const BodyJointGraph& graph_;
  std::vector<Vector6<S>> scale_;
  std::vector<std::array<bool, 6>> turns_;  ///< per edge and row: whether the row is about an angle
  std::vector<int> component_;              ///< per body, the ground last
  std::vector<Extent> extent_;
};

}  // namespace trivium
