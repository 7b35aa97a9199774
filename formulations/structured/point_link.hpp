#pragma once
/// A point link: its joint fixes a point, by three rows, and has m further orientation rows: spherical
/// (m = 0), universal (1), revolute (2), fixed or driven revolute (3). The body c is eliminated in the motion
/// that the joint leaves free. This is the articulated-body recursion (Featherstone 2008, section 7.3) in
/// absolute coordinates, with all multipliers. The body may lack inertia in motions that the joint prevents.
///
/// All equations refer to the joint's point. With the acceleration u of this point, and with the right side w
/// of the orientation rows after the motion of the parent p has been subtracted,
///
///     u = r_c'' + L_c^T x_c = r_p'' + L_p^T x_p + sign gamma      W_c^T x_c = w = gamma_w - W_p^T x_p
///     H_rr u + H_rx x_c + f = F      H_rx^T u + H_xx x_c + W_c lambda_w = tau      f = sign lambda_point
///
/// The ansatz is x_c = N q + Y w, where N^T W_c = 0 and Y^T W_c = I. N^T times the moment equation does not
/// contain lambda_w and gives q. Y^T times the moment equation gives lambda_w. The parent receives the
/// remainder, which depends on u and w only:
///
///     f = f_0 - rr u - Z w           lambda_w = s_0 - Z^T u - T w
///
/// Precondition: the orientation rows depend on relative rotation only, that is, W_p is -W_c in the parent's
/// axes. Otherwise the rows on the child (W_c) could be nearly dependent on each other while the rows on the
/// parent are not, and digits would be lost with the square of the sine. No point joint has such rows. A
/// GeneralLink may have them: there they become candidates, which are left out and examined later.

#include <array>

#include "bodies/numbers/scalar.hpp"
#include "formulations/structured/graph_system.hpp"

namespace trivium {

/// N and Y of the orientation rows W^T x = w: W^T N = 0, W^T Y = I. Returns false if the rows depend on each
/// other. The tolerance assumes columns of W of unit length. The length of their cross product is then a
/// sine, and their determinant a product of sines.
template <class S, int m>
bool solve_orientation(const PaddedColumns<S, 3>& W, PaddedColumns<S, 3 - m>& N, PaddedColumns<S, m>& Y) {
  using std::sqrt;
  const auto is_size = [](const S& squared) {
    return squared > direction_tolerance<S>() * direction_tolerance<S>();
  };
  const Padded<S> a = W.col(0), b = W.col(1), c = W.col(2);
  if constexpr (m == 0) {
    N.setIdentity();
    return true;
  } else if constexpr (m == 1) {
    // two directions perpendicular to a; n is y x a or z x a, whichever is not short
    const S zero(0), aa = a.squaredNorm();
    const auto is_flat = a.x() * a.x() + a.y() * a.y() < a.z() * a.z();
    const Padded<S> n = padded<S>(Vector3<S>(select(is_flat, a.z(), -a.y()), select(is_flat, zero, a.x()),
                                             select(is_flat, -a.x(), zero)));
    N.col(0) = n;
    N.col(1) = cross_product<S>(a, n) / S(sqrt(aa));
    Y = a / aa;
    return is_size(aa);
  } else if constexpr (m == 2) {
    const Padded<S> n = cross_product<S>(a, b);
    const S nn = n.squaredNorm(), inverse = 1 / nn;
    N = n;
    Y.col(0) = cross_product<S>(b, n) * inverse;
    Y.col(1) = cross_product<S>(n, a) * inverse;
    return is_size(nn);
  } else {
    const Padded<S> bc = cross_product<S>(b, c);
    const S determinant = a.dot(bc), inverse = 1 / determinant;
    Y.col(0) = bc * inverse;
    Y.col(1) = cross_product<S>(c, a) * inverse;
    Y.col(2) = cross_product<S>(a, b) * inverse;
    return is_size(determinant * determinant);
  }
}

/// The inverse of a symmetric positive definite block [n x n], n <= 3. Returns false if a pivot does not
/// exceed `least`, the rounding error of the block.
template <class S, int n>
bool invert_positive(const Matrix<S, n, n>& D, const S& least, Matrix<S, n, n>& inverse) {
  if constexpr (n == 0) {
    return true;
  } else if constexpr (n == 1) {
    inverse(0, 0) = 1 / D(0, 0);
    return D(0, 0) > least;
  } else {
    // by L D L^T; the inverse L^-T D^-1 L^-1 is multiplied out
    const S d0 = D(0, 0), i0 = 1 / d0, l10 = D(1, 0) * i0;
    const S d1 = D(1, 1) - l10 * D(1, 0), i1 = 1 / d1;
    bool good = d0 > least && d1 > least;
    if constexpr (n == 2) {
      inverse(1, 1) = i1;
      inverse(0, 1) = inverse(1, 0) = -l10 * i1;
      inverse(0, 0) = i0 + l10 * l10 * i1;
    } else {
      const S l20 = D(2, 0) * i0, e = D(2, 1) - l10 * D(2, 0), l21 = e * i1;
      const S d2 = D(2, 2) - l20 * D(2, 0) - l21 * e, i2 = 1 / d2;
      good = good && d2 > least;
      const S m20 = l10 * l21 - l20;  // entry (2, 0) of L^-1
      inverse(2, 2) = i2;
      inverse(1, 2) = inverse(2, 1) = -l21 * i2;
      inverse(0, 2) = inverse(2, 0) = m20 * i2;
      inverse(1, 1) = i1 + l21 * l21 * i2;
      inverse(0, 1) = inverse(1, 0) = -l10 * i1 - l21 * m20 * i2;
      inverse(0, 0) = i0 + l10 * l10 * i1 + m20 * m20 * i2;
    }
    return good;
  }
}

/// The factors of one link and its part of the current right side. Functions are flattened, because calls of
/// the small block operations would pass their blocks through memory.
template <class S, int m>
class PointLink {
 public:
  static constexpr int free = 3 - m;
  using Free = Vector<S, free>;

  /// Eliminates the body's block H and adds the remaining block to the parent's, if there is a parent.
  [[gnu::flatten]] Elimination factor(const BodyBlock<S>& H, const LinkRows<S>& link, BodyBlock<S>* parent,
                                      DependentRows, std::array<bool, 6>&) {
    const PointRows<S>& rows = link.point;
    if (!solve_orientation<S, m>(rows.W_child, N_, Y_)) return Elimination::dependent_rows;
    // the block about the joint's point: rx = H_rx - H_rr L^T and xx = H_xx - L X - (L X)^T, where
    // X = H_rx - H_rr L^T / 2 takes half of the quadratic term L H_rr L^T in each of the two products
    const PaddedColumns<S, 3> way = times_transpose<S, 3>(H.rr, rows.L_child);
    const PaddedColumns<S, 3> rx = H.rx - way, X = H.rx - way / 2;
    PaddedColumns<S, 3> xx = H.xx;
    add_with_transpose<S>(-times<S, 3>(rows.L_child, X), xx);
    U_r_ = times<S, 3>(rx, N_);
    const PaddedColumns<S, free> U_x = times<S, 3>(xx, N_);
    const Matrix<S, free, free> D = products<free>(N_, U_x);
    const S moments = xx.diagonal().cwiseAbs().sum() + H.xx.diagonal().cwiseAbs().sum();
    if (!invert_positive<S, free>(D, inertia_rounding<S>() / 2 * moments * N_.squaredNorm(), D_inverse_))
      return Elimination::no_inertia;
    const Matrix<S, free, m> carried = products<m>(U_x, Y_);
    P_ = D_inverse_ * carried;
    const PaddedColumns<S, free> E = times<S, free>(U_r_, D_inverse_);
    rr_ = H.rr - times_transpose<S, free>(E, U_r_);
    if constexpr (m > 0)
      for (int k = 0; k < m; ++k) {
        const Padded<S> Y = Y_.col(k);
        const Free P = P_.col(k);
        Z_.col(k) = times<S, 3>(rx, Y) - times<S, free>(U_r_, P);
        T_.col(k) = transpose_times<S, m>(Y_, times<S, 3>(xx, Y)) - carried.transpose() * P;
      }
    if (parent == nullptr) return Elimination::done;
    // substitutes u and w by the parent's r'' and x, where `arm` / 2 splits a quadratic term as X does
    const PaddedColumns<S, m> W = parent_rows(rows);
    const PaddedColumns<S, 3> arm = times_transpose<S, 3>(rr_, rows.L_parent);
    const PaddedColumns<S, 3> ZW = times_transpose<S, m>(Z_, W);
    parent->rr += rr_;
    parent->rx += arm - ZW;
    parent->xx += times_transpose<S, m>(times<S, m>(W, T_), W);
    add_with_transpose<S>(times<S, 3>(rows.L_parent, PaddedColumns<S, 3>(arm / 2 - ZW)), parent->xx);
    return Elimination::done;
  }

  /// Eliminates the body from the first n columns of a closing, and passes the remainder to the parent.
  [[gnu::flatten]] void factor(const BodyColumns<S>& C, int n, const LinkRows<S>& link, LinkColumn<S>& out,
                               ColumnSizes<S>& size, BodyColumns<S>* parent) const {
    const PointRows<S>& rows = link.point;
    const S yield = times<S, free>(N_, D_inverse_).cwiseProduct(N_).sum();
    const S lever_size = rows.L_child.squaredNorm();
    for (int k = 0; k < n; ++k) {
      const Padded<S> x = C.x.col(k) - times<S, 3>(rows.L_child, C.r.col(k));
      size.take(k, C.r.col(k).squaredNorm(), C.x.col(k).squaredNorm());
      size.product[k] += (size.x[k] + lever_size * size.r[k]) * yield;
      const Free g = transpose_times<S, free>(N_, x);
      out.g.row(k).template head<free>() = g.transpose();
      const Padded<S> rest_r = C.r.col(k) - times<S, free>(U_r_, Free(D_inverse_ * g));
      const Carried rest_w = transpose_times<S, m>(Y_, x) - P_.transpose() * g;
      out.rest_r.col(k) = rest_r;
      out.rest_x.col(k).template head<m>() = rest_w;
      if (parent == nullptr) continue;
      parent->r.col(k) += rest_r;
      parent->x.col(k) += times<S, 3>(rows.L_parent, rest_r) - times<S, m>(parent_rows(rows), rest_w);
    }
  }
  /// Adds a^T D^-1 b, the coupling of two closings through the free motion of this link, to `sum`.
  void couple(const LinkColumn<S>& a, const LinkColumn<S>& b, int rows_b, Matrix6<S>& sum) const {
    for (int n = 0; n < rows_b; ++n)
      sum.col(n) += a.g.template leftCols<free>() * (D_inverse_ * free_part(b, n));
  }

  /// Eliminates the body from the right side and adds the remainder to the parent's force.
  [[gnu::flatten]] void forward(const BodyPart<S>& force, const Vector6<S>& gamma, const LinkRows<S>& link,
                                BodyPart<S>* parent) {
    const PointRows<S>& rows = link.point;
    const Padded<S> tau = force.x - times<S, 3>(rows.L_child, force.r);
    const Free push = transpose_times<S, free>(N_, tau);
    q_ = D_inverse_ * push;
    f_ = force.r - times<S, free>(U_r_, q_);
    s_ = transpose_times<S, m>(Y_, tau) - P_.transpose() * push;
    u_ = rows.sign * padded<S>(gamma.template head<3>());
    w_ = gamma.template segment<m>(3);
    if (parent == nullptr) return;
    const Padded<S> f = f_ - times<S, 3>(rr_, u_) - times<S, m>(Z_, w_);
    const Carried s = s_ - transpose_times<S, m>(Z_, u_) - T_ * w_;
    parent->r += f;
    parent->x += times<S, 3>(rows.L_parent, f) - times<S, m>(parent_rows(rows), s);
  }
  /// Subtracts the terms of the joint from the right sides, which then are residuals. The forces of lambda
  /// are subtracted from the forces on both bodies, the accelerations along the rows from gamma.
  [[gnu::flatten]] static void take_residual(const LinkRows<S>& link, const BodyPart<S>& child,
                                             const BodyPart<S>* parent, const Vector6<S>& lambda,
                                             BodyPart<S>& on_child, BodyPart<S>* on_parent,
                                             Vector6<S>& gamma) {
    const PointRows<S>& rows = link.point;
    const Padded<S> f = rows.sign * padded<S>(lambda.template head<3>());
    const Carried carried = lambda.template segment<m>(3);
    Padded<S> u = child.r + padded_transpose_times<S>(rows.L_child, child.x);
    Carried w = transpose_times<S, m>(child_rows(rows), child.x);
    on_child.r -= f;
    on_child.x -= times<S, 3>(rows.L_child, f) + times<S, m>(child_rows(rows), carried);
    if (parent != nullptr) {
      u -= parent->r + padded_transpose_times<S>(rows.L_parent, parent->x);
      w += transpose_times<S, m>(parent_rows(rows), parent->x);
      on_parent->r += f;
      on_parent->x += times<S, 3>(rows.L_parent, f) - times<S, m>(parent_rows(rows), carried);
    }
    gamma.template head<3>() -= rows.sign * unpadded<S>(u);
    gamma.template segment<m>(3) -= w;
  }
  /// C^T a of row k of a closing, for the motion a that this link's gamma and force cause if the parent is at
  /// rest.
  S closing_rate(const LinkColumn<S>& c, int k) const {
    return c.rest_r.col(k).dot(u_) + c.rest_x.col(k).template head<m>().dot(w_) + free_part(c, k).dot(q_);
  }
  /// Subtracts the forces of a multiplier of a closing, once it is known, from the link's right side.
  void add_multiplier(const LinkColumn<S>& c, int k, const S& lambda) {
    const Free q = D_inverse_ * free_part(c, k);
    q_ -= q * lambda;
    f_ -= lambda * c.rest_r.col(k);
    s_ -= lambda * c.rest_x.col(k).template head<m>();
  }

  /// Back substitution: the body's accelerations and the joint's multipliers from the parent's accelerations.
  [[gnu::flatten]] void backward(const BodyPart<S>* parent, const LinkRows<S>& link, BodyPart<S>& a,
                                 Vector6<S>& lambda) const {
    const PointRows<S>& rows = link.point;
    if (parent == nullptr) return place(u_, w_, rows, a, lambda);
    place(u_ + parent->r + padded_transpose_times<S>(rows.L_parent, parent->x),
          w_ - transpose_times<S, m>(parent_rows(rows), parent->x), rows, a, lambda);
  }

 private:
  using Carried = Vector<S, m>;

  static Free free_part(const LinkColumn<S>& c, int k) {
    return c.g.row(k).template head<free>().transpose();
  }
  /// The body's accelerations a and the joint's multipliers for given u and w.
  [[gnu::always_inline]] inline void place(const Padded<S>& u, const Carried& w, const PointRows<S>& rows,
                                           BodyPart<S>& a, Vector6<S>& lambda) const {
    lambda.template head<3>() = rows.sign * unpadded<S>(f_ - times<S, 3>(rr_, u) - times<S, m>(Z_, w));
    lambda.template segment<m>(3) = s_ - transpose_times<S, m>(Z_, u) - T_ * w;
    const Free q = q_ - D_inverse_ * transpose_times<S, free>(U_r_, u) - P_ * w;
    const Padded<S> x = times<S, free>(N_, q) + times<S, m>(Y_, w);
    a.x = x;
    a.r = u - padded_transpose_times<S>(rows.L_child, x);
  }

  /// M^T N, column by column.
  template <int columns, int rows>
  static Matrix<S, rows, columns> products(const PaddedColumns<S, rows>& M,
                                           const PaddedColumns<S, columns>& N) {
    Matrix<S, rows, columns> product;
    if constexpr (columns > 0)
      for (int k = 0; k < columns; ++k) product.col(k) = transpose_times<S, rows>(M, N.col(k));
    return product;
  }
  static PaddedColumns<S, m> child_rows(const PointRows<S>& rows) {
    return rows.W_child.template leftCols<m>();
  }
  static PaddedColumns<S, m> parent_rows(const PointRows<S>& rows) {
    return rows.W_parent.template leftCols<m>();
  }

  PaddedColumns<S, free> N_;
  PaddedColumns<S, m> Y_;
  // U_r = H_rx N, D^-1 = (N^T H_xx N)^-1 and P = D^-1 N^T H_xx Y, with H about the joint's point
  PaddedColumns<S, free> U_r_;
  Matrix<S, free, free> D_inverse_;
  Matrix<S, free, m> P_;
  // the block that remains for the parent: f and lambda_w by u and w
  PaddedColumns<S, 3> rr_;
  PaddedColumns<S, m> Z_;
  Matrix<S, m, m> T_;
  // the current right side
  Free q_;
  Padded<S> f_, u_;
  Carried s_, w_;
};

}  // namespace trivium
