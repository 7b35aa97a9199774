#pragma once
/// Evaluates all rows of a point joint (spherical, revolute, ...) together: three CD rows that hold a point,
/// and up to three orientation rows. Rotated axes and their rates, which rows share, are computed once.

#include <array>
#include <variant>

#include "bodies/numbers/register_vectors.hpp"
#include "bodies/point_offset.hpp"
#include "bodies/rotations/so3.hpp"
#include "constraints/basic_constraint.hpp"
#include "constraints/constraint_row.hpp"
#include "formulations/contract/angular_motion.hpp"
#include "formulations/structured/body_joint_graph.hpp"
#include "mechanism/mechanism.hpp"

namespace trivium {

/// Three CD rows along the global axes between a point of i and a point of j, then at most three orientation
/// rows. Most orientation rows are plain DP1 rows a . b = 0, whose moment is a x b. With the rotational
/// unknown x of a body, L^T x is the part of the point's acceleration that is linear in x:
///
///     r_j'' + L_j^T x_j - r_i'' - L_i^T x_i = gamma      W_i^T x_i + W_j^T x_j = gamma_w
template <class S, class Types>
class PointJoint {
 public:
  PointJoint(const Mechanism<S, Types>& mechanism, const GraphEdge& edge)
      : mechanism_(&mechanism), bodies_(edge) {
    const auto& point = std::get<CD<S>>(mechanism.rows[edge.rows[0]]);
    on_i_.index_of(point.s_bar_i);
    on_j_.index_of(point.s_bar_j);
    for (std::size_t k = 3; k < edge.rows.size(); ++k) {
      const auto* row = std::get_if<DP1<S>>(&mechanism.rows[edge.rows[k]]);
      const bool is_plain = row != nullptr && row->i == edge.i && row->f.is_number();
      has_others_ = has_others_ || !is_plain;
      rows_[size_++] = {is_plain ? on_i_.index_of(row->a_bar_i) : -1,
                        is_plain ? on_j_.index_of(row->a_bar_j) : -1, edge.rows[k]};
    }
  }

  /// Number of orientation rows.
  int size() const { return size_; }

  /// Writes the Jacobians L and W of both bodies (a column per row) and gamma of all rows.
  template <class Body, class Columns>
  [[gnu::flatten]] void evaluate(const std::vector<AngularMotion<S>>& motion, const std::vector<Body>& body,
                                 const S& t, Columns&& L_i, Columns&& L_j, Columns&& W_i, Columns&& W_j,
                                 Vector<S, 6>& gamma) const {
    const AngularMotion<S>&i = motion[bodies_.i], &j = motion[bodies_.j];
    const Moved moved_i(i, on_i_), moved_j(j, on_j_);
    L_i = times_tilde<S>(i.axes_T, moved_i.a[0]);
    L_j = times_tilde<S>(j.axes_T, moved_j.a[0]);
    gamma.template head<3>() = unpadded<S>(moved_i.bias[0] - moved_j.bias[0]);
    for (int k = 0; k < size_; ++k) {
      if (rows_[k].i < 0) continue;
      const Padded<S>&a = moved_i.a[rows_[k].i], &b = moved_j.a[rows_[k].j];
      const Padded<S> moment = cross_product<S>(a, b);
      W_i.col(k) = times<S, 3>(i.axes_T, moment);
      W_j.col(k) = times<S, 3>(j.axes_T, Padded<S>(-moment));
      gamma[3 + k] = -(moved_i.bias[rows_[k].i].cwiseProduct(b) + moved_j.bias[rows_[k].j].cwiseProduct(a) +
                       S(2) * moved_i.rate[rows_[k].i].cwiseProduct(moved_j.rate[rows_[k].j]))
                          .sum();
    }
    if (has_others_) evaluate_others(body, t, W_i, W_j, gamma);
  }

  /// Phi of all rows.
  template <class Body>
  void positions(const std::vector<Body>& body, const S& t, Vector<S, 6>& phi) const {
    const Body &i = body[bodies_.i], &j = body[bodies_.j];
    phi.template head<3>() = offset_between<S>(i.r, i.A * on_i_.a_bar[0], j.r, j.A * on_j_.a_bar[0]);
    for (int k = 0; k < size_; ++k)
      if (rows_[k].i < 0)
        phi[3 + k] = of_row([](const auto&... of) { return row_position(of...); }, body, t, k);
      else
        phi[3 + k] = (i.A * on_i_.a_bar[rows_[k].i]).dot(j.A * on_j_.a_bar[rows_[k].j]);
  }

  /// Phi' of all rows.
  template <class Body>
  void velocities(const std::vector<AngularMotion<S>>& motion, const std::vector<Body>& body, const S& t,
                  Vector<S, 6>& phi_dot) const {
    const AngularMotion<S>&i = motion[bodies_.i], &j = motion[bodies_.j];
    const Moving moving_i(i, on_i_), moving_j(j, on_j_);
    phi_dot.template head<3>() =
        (body[bodies_.j].r_dot - body[bodies_.i].r_dot) + unpadded<S>(moving_j.rate[0] - moving_i.rate[0]);
    for (int k = 0; k < size_; ++k)
      if (rows_[k].i < 0)
        phi_dot[3 + k] = of_row([](const auto&... of) { return row_velocity(of...); }, body, t, k);
      else
        phi_dot[3 + k] = moving_i.rate[rows_[k].i].dot(moving_j.a[rows_[k].j]) +
                         moving_i.a[rows_[k].i].dot(moving_j.rate[rows_[k].j]);
  }

 private:
  template <class Body, class Of>
  S of_row(const Of& of, const std::vector<Body>& body, const S& t, int k) const {
    const auto& constraint = mechanism_->rows[rows_[k].row];
    const BodyPair pair = bodies_of(constraint);
    return of(constraint, body[pair.i], body[pair.j], t);
  }
  /// Evaluates the orientation rows that are not plain DP1 rows, such as drivers.
  template <class Body, class Columns>
  [[gnu::noinline]] void evaluate_others(const std::vector<Body>& body, const S& t, Columns&& W_i,
                                         Columns&& W_j, Vector<S, 6>& gamma) const {
    for (int k = 0; k < size_; ++k) {
      if (rows_[k].i >= 0) continue;
      const auto& constraint = mechanism_->rows[rows_[k].row];
      const BodyPair pair = bodies_of(constraint);
      auto row = evaluate_row(constraint, body[pair.i], body[pair.j], t);
      if (pair.i != bodies_.i) row.rot_i.swap(row.rot_j);
      W_i.col(k) = padded<S>(row.rot_i.transpose());
      W_j.col(k) = padded<S>(row.rot_j.transpose());
      gamma[3 + k] = row.gamma;
    }
  }

  /// The different vectors on a body [body frame]: first that to the joint's point, then those of the rows.
  struct Vectors {
    std::array<Vector3<S>, 4> a_bar;
    int size = 0;

    int index_of(const Vector3<S>& vector) {
      int k = 0;
      while (k < size && !are_same(a_bar[k], vector)) ++k;
      if (k == size) a_bar[size++] = vector;
      return k;
    }
    static bool are_same(const Vector3<S>& a, const Vector3<S>& b) {
      return all(a[0] == b[0]) && all(a[1] == b[1]) && all(a[2] == b[2]);
    }
  };
  /// The vectors of a body in the global frame, and their rates.
  struct Moving {
    std::array<Padded<S>, 4> a, rate;

    Moving(const AngularMotion<S>& body, const Vectors& of) {
      for (int k = 0; k < of.size; ++k) {
        a[k] = times<S, 3>(body.A, of.a_bar[k]);
        rate[k] = cross_product<S>(body.omega, a[k]);
      }
    }
  };
  /// Like Moving, and the bias: the part of the second derivatives that does not depend on the unknowns x.
  struct Moved {
    std::array<Padded<S>, 4> a, rate, bias;

    Moved(const AngularMotion<S>& body, const Vectors& of) {
      for (int k = 0; k < of.size; ++k) {
        a[k] = times<S, 3>(body.A, of.a_bar[k]);
        rate[k] = cross_product<S>(body.omega, a[k]);
        bias[k] = cross_product<S>(body.drift, a[k]) + cross_product<S>(body.omega, rate[k]);
      }
    }
  };
  struct Orientation {
    int i, j;  ///< indices of the row's vectors in on_i_ and on_j_; -1 if the row is not a plain DP1
    int row;   ///< index of the row in the mechanism
  };

  const Mechanism<S, Types>* mechanism_;
  BodyPair bodies_;
  Vectors on_i_, on_j_;
  std::array<Orientation, 3> rows_;
  int size_ = 0;
  bool has_others_ = false;
};

}  // namespace trivium
