#pragma once
/// A body that hangs on its parent by a point joint with m further rows of orientation: spherical (m = 0),
/// universal (1), revolute (2), and fixed or a driven revolute (3). Eliminated in the motion that the joint
/// leaves free, which is the articulated-body recursion (Featherstone 2008, section 7.3) in absolute
/// coordinates, with every multiplier. The body's block may be singular wherever the joint holds it.
///
/// With u the acceleration of the common point, u = r_c'' + K_c x_c = r_p'' + K_p x_p + sign gamma:
///
///   H_rr u + H_rx x_c + f = F        H_rx^T u + H_xx x_c + t = tau      (blocks moved to the point)
///   x_c = Y (gamma_w - W_p^T x_p) + N q,   N^T t = 0,   f = sign lambda_point,   t = W_c lambda_w

#include <array>

#include "bodies/lanes.hpp"
#include "bodies/scalar.hpp"
#include "formulations/graph_system.hpp"

namespace trivium {

/// N and Y of the orientation rows W^T x = z: W^T N = 0, W^T Y = I.
template <class S, int m>
struct OrientationRows {
  static constexpr int free = 3 - m;
  Matrix<S, 3, free> N;
  Matrix<S, 3, m> Y;

  explicit OrientationRows(const Matrix3<S>& W) {
    const Vector3<S> a = W.col(0), b = W.col(1), c = W.col(2);
    if constexpr (m == 0) {
      N.setIdentity();
    } else if constexpr (m == 1) {
      // two directions across a; neither is short
      const S zero(0), aa = a.squaredNorm();
      const auto is_flat = a.x() * a.x() + a.y() * a.y() < a.z() * a.z();
      const Vector3<S> n(select(is_flat, a.z(), -a.y()), select(is_flat, zero, a.x()),
                         select(is_flat, -a.x(), zero));
      N.col(0) = n;
      N.col(1) = a.cross(n) / sqrt_of(aa);
      Y = a / aa;
    } else if constexpr (m == 2) {
      N = a.cross(b);
      const S inverse = 1 / N.squaredNorm();
      Y.col(0) = b.cross(Vector3<S>(N)) * inverse;
      Y.col(1) = Vector3<S>(N).cross(a) * inverse;
    } else {
      const Vector3<S> bc = b.cross(c);
      const S inverse = 1 / a.dot(bc);
      Y.col(0) = bc * inverse;
      Y.col(1) = c.cross(a) * inverse;
      Y.col(2) = a.cross(b) * inverse;
    }
  }

 private:
  static S sqrt_of(const S& x) {
    using std::sqrt;
    return sqrt(x);
  }
};

/// The inverse of a symmetric positive definite block of at most three rows; false where a pivot is not above
/// `least`, which is the rounding of the block.
template <class S, int n>
bool invert_positive(const Matrix<S, n, n>& D, const S& least, Matrix<S, n, n>& inverse) {
  if constexpr (n == 0) {
    return true;
  } else if constexpr (n == 1) {
    inverse(0, 0) = 1 / D(0, 0);
    return all(D(0, 0) > least);
  } else {
    // L D L^T, its own inverse multiplied out
    const S d0 = D(0, 0), i0 = 1 / d0, l10 = D(1, 0) * i0;
    const S d1 = D(1, 1) - l10 * D(1, 0), i1 = 1 / d1;
    bool good = all(d0 > least) && all(d1 > least);
    if constexpr (n == 2) {
      inverse(1, 1) = i1;
      inverse(0, 1) = inverse(1, 0) = -l10 * i1;
      inverse(0, 0) = i0 + l10 * l10 * i1;
    } else {
      const S l20 = D(2, 0) * i0, e = D(2, 1) - l10 * D(2, 0), l21 = e * i1;
      const S d2 = D(2, 2) - l20 * D(2, 0) - l21 * e, i2 = 1 / d2;
      good = good && all(d2 > least);
      const S m20 = l10 * l21 - l20;  // of L^-1
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

template <class S, int m>
class PointLink {
 public:
  static constexpr int free = 3 - m;
  using Free = Vector<S, free>;

  /// Eliminates the body's block H; adds what is left of it to the parent's, if there is one.
  Elimination factor(const BodyBlock<S>& H, const LinkRows<S>& link, BodyBlock<S>* parent,
                     std::array<bool, 6>&) {
    const PointRows<S>& rows = link.point;
    const OrientationRows<S, m> orientation(rows.W_child);
    N_ = orientation.N;
    Y_ = orientation.Y;
    const Matrix3<S>& K = rows.K_child;
    const Matrix3<S> HK = H.rr * K, KH = K.transpose() * H.rx;
    const Matrix3<S> rx = H.rx - HK;  // about the point
    const Matrix3<S> xx = H.xx - KH - KH.transpose() + K.transpose() * HK;
    U_r_.noalias() = rx * N_;
    U_x_.noalias() = xx * N_;
    const Matrix<S, free, free> D = N_.transpose() * U_x_;
    const S rounding = 8 * unit_roundoff<S>() * xx.diagonal().cwiseAbs().sum() * N_.squaredNorm();
    if (!invert_positive<S, free>(D, rounding, D_inverse_)) return Elimination::no_inertia;
    const Matrix<S, 3, free> E_r = U_r_ * D_inverse_, E_x = U_x_ * D_inverse_;
    rr_ = H.rr - E_r * U_r_.transpose();
    rx_ = rx - E_r * U_x_.transpose();
    xx_ = xx - E_x * U_x_.transpose();
    if (parent == nullptr) return Elimination::done;
    V_.noalias() = -Y_ * rows.W_parent.template leftCols<m>().transpose();
    const Matrix3<S>& Kp = rows.K_parent;
    const Matrix3<S> r = rr_ * Kp + rx_ * V_, x = rx_.transpose() * Kp + xx_ * V_;
    parent->rr += rr_;
    parent->rx += r;
    parent->xx += Kp.transpose() * r + V_.transpose() * x;
    return Elimination::done;
  }

  /// The same for the columns C of a closing on the body.
  void factor(const Matrix6<S>& C, int n, const LinkRows<S>& link, LinkColumn<S>& out,
              Matrix6<S>* parent) const {
    const PointRows<S>& rows = link.point;
    for (int k = 0; k < n; ++k) {
      const Vector3<S> r = C.col(k).template head<3>();
      const Vector3<S> x = C.col(k).template tail<3>() - rows.K_child.transpose() * r;
      const Free g = N_.transpose() * x, q = D_inverse_ * g;
      out.g.col(k).template head<free>() = g;
      const Vector3<S> rest_r = r - U_r_ * q, rest_x = x - U_x_ * q;
      out.rest.col(k).template head<3>() = rest_r;
      out.rest.col(k).template tail<3>() = rest_x;
      if (parent == nullptr) continue;
      parent->col(k).template head<3>() += rest_r;
      parent->col(k).template tail<3>() += rows.K_parent.transpose() * rest_r + V_.transpose() * rest_x;
    }
  }
  /// a^T D^-1 b of two closings' free parts.
  S product(const LinkColumn<S>& a, int k, const LinkColumn<S>& b, int n) const {
    return a.g.col(k).template head<free>().dot(D_inverse_ * b.g.col(n).template head<free>());
  }
  /// The size that this product of column k with itself would have if nothing cancelled.
  S bound(const Matrix6<S>& C, int k, const LinkRows<S>& link) const {
    const Vector3<S> lever = link.point.K_child.transpose() * C.col(k).template head<3>();
    return (C.col(k).template tail<3>().squaredNorm() + lever.squaredNorm()) *
           (N_ * D_inverse_).cwiseProduct(N_).sum();
  }

  /// Passes the right side up: what the parent's equations receive.
  void forward(const Vector6<S>& force, const Vector6<S>& gamma, const LinkRows<S>& link,
               Vector6<S>* parent) {
    const PointRows<S>& rows = link.point;
    const Vector3<S> F = force.template head<3>();
    const Vector3<S> tau = force.template tail<3>() - rows.K_child.transpose() * F;
    q_.noalias() = D_inverse_ * (N_.transpose() * tau);
    f_ = F - U_r_ * q_;
    t_ = tau - U_x_ * q_;
    u_ = rows.sign * gamma.template head<3>();
    x_.noalias() = Y_ * gamma.template segment<m>(3);
    if (parent == nullptr) return;
    const Vector3<S> f = f_ - rr_ * u_ - rx_ * x_, t = t_ - rx_.transpose() * u_ - xx_ * x_;
    parent->template head<3>() += f;
    parent->template tail<3>() += rows.K_parent.transpose() * f + V_.transpose() * t;
  }
  /// What the link's own gamma and force do to a closing's right side.
  S closing_rate(const LinkColumn<S>& c, int k) const {
    return c.rest.col(k).template head<3>().dot(u_) + c.rest.col(k).template tail<3>().dot(x_) +
           c.g.col(k).template head<free>().dot(q_);
  }
  /// Takes the closing's multiplier into the right side.
  void add_multiplier(const LinkColumn<S>& c, int k, const S& lambda) {
    const Free q = D_inverse_ * c.g.col(k).template head<free>();
    q_ -= q * lambda;
    f_ -= lambda * c.rest.col(k).template head<3>();
    t_ -= lambda * c.rest.col(k).template tail<3>();
  }

  /// The body's accelerations and the joint's multipliers from the parent's accelerations.
  void backward(const Vector6<S>* parent, const LinkRows<S>& link, Vector6<S>& a, Vector6<S>& lambda) const {
    const PointRows<S>& rows = link.point;
    Vector3<S> u = u_, x = x_;
    if (parent != nullptr) {
      u += parent->template head<3>() + rows.K_parent * parent->template tail<3>();
      x += V_ * parent->template tail<3>();
    }
    lambda.template head<3>() = rows.sign * (f_ - rr_ * u - rx_ * x);
    lambda.template segment<m>(3).noalias() = Y_.transpose() * (t_ - rx_.transpose() * u - xx_ * x);
    x += N_ * (q_ - D_inverse_ * (U_r_.transpose() * u + U_x_.transpose() * x));
    a.template head<3>() = u - rows.K_child * x;
    a.template tail<3>() = x;
  }

 private:
  // the joint: W^T N = 0, W^T Y = I, V = -Y W_p^T
  Matrix<S, 3, free> N_;
  Matrix<S, 3, m> Y_;
  Matrix3<S> V_;
  // the block about the point: along the free motion, and what is left of it
  Matrix<S, 3, free> U_r_, U_x_;
  Matrix<S, free, free> D_inverse_;
  Matrix3<S> rr_, rx_, xx_;
  // the right side at hand
  Free q_;
  Vector3<S> f_, t_, u_, x_;
};

}  // namespace trivium
