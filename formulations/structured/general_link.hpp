#pragma once
/// A link whose joint to the parent is any edge of at most six rows, or no joint at all. M is the block of
/// the body, called H_b in graph_system.hpp; H is a basis of its free motions. Phi are the rows on the body,
/// P those on the parent, a and a_p the unknowns of body and parent:
///
///     M a + Phi^T lambda = F,   Phi a + P a_p = gamma,   a = Y (gamma - P a_p) + H q
///
/// Gauss-Jordan elimination of the rows gives Y and H with Phi Y = I, Phi H = 0. The columns of H are the
/// motions that the joint leaves free. The body is then eliminated in the coordinates q of these motions, in
/// which its inertia is D = H^T M H. PointLink is the faster special case of point joints.

#include <array>

#include "bodies/numbers/scalar.hpp"
#include "formulations/structured/graph_system.hpp"

namespace trivium {

/// The factors of one link and its part of the current right side. PointLink states what the functions do.
template <class S>
class GeneralLink {
 public:
  /// Eliminates the body's block and adds the remaining block to the parent's, if there is a parent. If a row
  /// on this body depends, or nearly depends, on rows before it, it gets the multiplier 0 and is marked in
  /// `dependent`. Rows that are marked on entry stay dependent.
  Elimination factor(const BodyBlock<S>& block, const LinkRows<S>& link, BodyBlock<S>* parent,
                     DependentRows how, std::array<bool, 6>& dependent) {
    Matrix6<S> M;
    M.template topLeftCorner<3, 3>() = block.rr.template topRows<3>();
    M.template topRightCorner<3, 3>() = block.rx.template topRows<3>();
    M.template bottomLeftCorner<3, 3>() = block.rx.template topRows<3>().transpose();
    M.template bottomRightCorner<3, 3>() = block.xx.template topRows<3>();
    solve_rows(M, link, how, dependent);
    const Vector6<S> size = M.diagonal();
    // A moment of inertia this small compared with the largest one may be rounding error: it counts as zero
    // in the sizes of columns. 1e-8, half of the digits of a double, is chosen by experiment.
    constexpr double rounded_moment = 1e-8;
    const S least = S(rounded_moment) * largest_of(size.template tail<3>());
    for (int k = 0; k < 6; ++k)
      inverse_size_[k] = select(size[k] > (k < 3 ? S(0) : least), S(1 / size[k]), S(0));
    U_ = M * H_;
    if (!invert(H_.transpose() * U_, H_.cwiseAbs2().transpose() * size)) return Elimination::no_inertia;
    rest_ = M - U_ * D_inverse_ * U_.transpose();
    if (parent == nullptr) return Elimination::done;
    const Matrix6<S> left = V_.transpose() * rest_ * V_;
    parent->rr.template topRows<3>() += left.template topLeftCorner<3, 3>();
    parent->rx.template topRows<3>() += left.template topRightCorner<3, 3>();
    parent->xx.template topRows<3>() += left.template bottomRightCorner<3, 3>();
    return Elimination::done;
  }

  /// Whether a row was taken for dependent although its remainder exceeds rounding error.
  bool has_nearly_dependent_rows() const { return has_nearly_dependent_rows_; }

  /// Eliminates the body from the first n columns of a closing, and passes the remainder to the parent.
  void factor(const BodyColumns<S>& columns, int n, const LinkRows<S>&, LinkColumn<S>& out,
              ColumnSizes<S>& size, BodyColumns<S>* parent) const {
    const Matrix6<S> C = columns.six();
    for (int k = 0; k < n; ++k) {
      const Vector6<S> squares = C.col(k).cwiseAbs2();
      const S r = squares.template head<3>().sum(), x = squares.template tail<3>().sum();
      size.take(k, r, x);
      // The translational and the rotational part of the column may have cancelled on the way from body to
      // body. The squares of each part are scaled up to the largest size that it had so far, its size before
      // the cancellation.
      const auto whole = [](const S& was, const S& is) { return select(is > S(0), S(was / is), S(0)); };
      size.product[k] +=
          whole(size.r[k], r) * squares.template head<3>().dot(inverse_size_.template head<3>()) +
          whole(size.x[k], x) * squares.template tail<3>().dot(inverse_size_.template tail<3>());
      const Free g = H_.transpose() * C.col(k);
      out.g.row(k).setZero();
      out.g.row(k).head(g.size()) = g.transpose();
      const Vector6<S> left = C.col(k) - U_ * (D_inverse_ * g);
      const BodyPart<S> rest = BodyPart<S>::of(left);
      out.rest_r.col(k) = rest.r;
      out.rest_x.col(k) = rest.x;
      if (parent == nullptr) continue;
      const BodyPart<S> passed = BodyPart<S>::of(V_.transpose() * left);
      parent->r.col(k) += passed.r;
      parent->x.col(k) += passed.x;
    }
  }
  /// Adds a^T D^-1 b, the coupling of two closings through the free motion of this link, to `sum`.
  void couple(const LinkColumn<S>& a, const LinkColumn<S>& b, int rows_b, Matrix6<S>& sum) const {
    for (int n = 0; n < rows_b; ++n) sum.col(n) += a.g.leftCols(free()) * Free(D_inverse_ * free_part(b, n));
  }

  void forward(const BodyPart<S>& force, const Vector6<S>& gamma, const LinkRows<S>&, BodyPart<S>* parent) {
    const Vector6<S> applied = force.six();
    q_ = D_inverse_ * (H_.transpose() * applied);
    f_ = applied - U_ * q_;
    a_ = Y_ * gamma;
    if (parent != nullptr) *parent += BodyPart<S>::of(V_.transpose() * (f_ - rest_ * a_));
  }
  S closing_rate(const LinkColumn<S>& c, int k) const {
    return rest_of(c, k).dot(a_) + free_part(c, k).dot(q_);
  }
  void add_multiplier(const LinkColumn<S>& c, int k, const S& lambda) {
    q_ -= lambda * (D_inverse_ * free_part(c, k));
    f_ -= lambda * rest_of(c, k);
  }
  void backward(const BodyPart<S>* parent, const LinkRows<S>&, BodyPart<S>& out, Vector6<S>& lambda) const {
    Vector6<S> a = a_;
    if (parent != nullptr) a += V_ * parent->six();
    lambda = Y_.transpose() * (f_ - rest_ * a);
    a += H_ * (q_ - D_inverse_ * (U_.transpose() * a));
    out = BodyPart<S>::of(a);
  }

 private:
  using Free = Eigen::Matrix<S, Eigen::Dynamic, 1, 0, 6, 1>;
  using Motion = Eigen::Matrix<S, 6, Eigen::Dynamic, 0, 6, 6>;
  using Block = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

  int free() const { return static_cast<int>(H_.cols()); }
  Free free_part(const LinkColumn<S>& c, int k) const { return c.g.row(k).head(free()).transpose(); }
  static Vector6<S> rest_of(const LinkColumn<S>& c, int k) {
    return BodyPart<S>{c.rest_r.col(k), c.rest_x.col(k)}.six();
  }

  /// Works lane by lane for batches, unlike Eigen's maxCoeff().
  static S largest_of(const Vector3<S>& v) { return larger(larger(v[0], v[1]), v[2]); }

  /// Gauss-Jordan elimination on [Phi | P | I]. The pivot of a row is its largest entry after column k is
  /// weighted by 1 / sqrt(M_kk). Unknowns with little inertia thus become pivots first, and the free unknowns
  /// have inertia.
  void solve_rows(const Matrix6<S>& M, const LinkRows<S>& link, DependentRows how,
                  std::array<bool, 6>& dependent) {
    using std::abs, std::sqrt;
    const int rows = link.count;
    const Matrix6<S> C = link.C.six(), C_parent = link.C_parent.six();
    Matrix<S, 6, 18> G;
    G.template leftCols<6>() = C.transpose();
    G.template middleCols<6>(6) = C_parent.transpose();
    G.template rightCols<6>().setIdentity();
    // Let the lever be the length |x| / |r| of a row's rotational and translational parts. If a moment of
    // inertia were far below mass * lever^2, its column would get a large weight. The rounding errors of the
    // column would then make a dependent row look independent. The scale of the moments is therefore at least
    // mass * lever^2.
    S lever2(0);
    for (int k = 0; k < rows; ++k) {
      const S r2 = link.C.r.col(k).squaredNorm(), x2 = link.C.x.col(k).squaredNorm();
      lever2 = larger(lever2, select(r2 > S(0), S(x2 / r2), S(0)));
    }
    const S masses = largest_of(M.diagonal().template head<3>());
    const S moments = larger(largest_of(M.diagonal().template tail<3>()), S(masses * lever2));
    // The limit 1e-6 keeps the ratio of the weights of two translations, or of two rotations, at most 1000.
    // It is chosen by experiment: larger ratios magnify rounding errors, smaller ones leave unknowns without
    // inertia free.
    Vector6<S> weight;
    for (int k = 0; k < 6; ++k) {
      const S& largest = k < 3 ? masses : moments;
      const S least = select(largest > S(0), S(S(1e-6) * largest), S(1));
      weight[k] = 1 / S(sqrt(select(M(k, k) > least, M(k, k), least)));
    }
    // sums of the magnitudes of the terms in G, with which the remainder of a row is compared
    Matrix6<S> made_of = C.transpose().cwiseAbs();
    std::array<int, 6> pivot_of_row;
    std::array<bool, 6> is_basic{};
    const S tolerance = how == DependentRows::keep     ? joint_row_rounding<S>()
                        : how == DependentRows::detect ? examined_joint_row_tolerance<S>()
                                                       : joint_row_tolerance<S>();
    const std::array<bool, 6> marked = dependent;
    has_nearly_dependent_rows_ = false;
    // in the order of the rows, without row exchanges: a row is dependent if it depends on rows before it
    for (int r = 0; r < rows; ++r) {
      int best = -1;
      S best_pull(0), largest(0), size(0);
      for (int k = 0; k < 6; ++k) {
        const S p = abs(G(r, k)) * weight[k], whole = made_of(r, k) * weight[k];
        size = larger(size, whole);
        if (is_basic[k]) continue;
        largest = larger(p, largest);
        if (best < 0 || least_lane(p) > least_lane(best_pull)) {
          best = k;
          best_pull = p;
        }
      }
      const S least_pull = tolerance * size;
      dependent[r] = best < 0 || marked[r] || largest <= least_pull;
      if (dependent[r]) {
        has_nearly_dependent_rows_ =
            has_nearly_dependent_rows_ || any(largest > joint_row_rounding<S>() * size);
        G.row(r).setZero();
        continue;
      }
      if (best_pull <= least_pull) throw MixedLanes();  // no column is a pivot in all lanes
      is_basic[best] = true;
      pivot_of_row[r] = best;
      const S inverse = 1 / G(r, best);
      G.row(r) *= inverse;
      made_of.row(r) *= abs(inverse);
      for (int other = 0; other < rows; ++other) {
        if (other == r || (other < r && dependent[other])) continue;
        const S factor = G(other, best);
        G.row(other) -= factor * G.row(r);
        made_of.row(other) += abs(factor) * made_of.row(r);
      }
    }
    Y_.setZero();
    V_.setZero();
    int free = 0;
    for (int k = 0; k < 6; ++k) free += is_basic[k] ? 0 : 1;
    H_.setZero(6, free);
    for (int r = 0; r < rows; ++r) {
      if (dependent[r]) continue;
      Y_.row(pivot_of_row[r]) = G.row(r).template tail<6>();
      V_.row(pivot_of_row[r]) = -G.row(r).template segment<6>(6);
    }
    for (int k = 0, n = 0; k < 6; ++k) {
      if (is_basic[k]) continue;
      H_(k, n) = S(1);
      for (int r = 0; r < rows; ++r)
        if (!dependent[r]) H_(pivot_of_row[r], n) = -G(r, k);
      ++n;
    }
  }

  /// Computes D^-1 by Gauss elimination of whole rows of [D | I], without exchanges since D is symmetric and
  /// positive definite. Returns false if a pivot is rounding error compared with `made_of`, the sizes of the
  /// terms of the diagonal of D.
  bool invert(const Block& D, const Free& made_of) {
    const int n = free();
    Block L = D;
    bool good = true;
    D_inverse_.setIdentity(n, n);
    for (int k = 0; k < n; ++k) {
      good = good && L(k, k) > inertia_rounding<S>() * larger(made_of[k], S(0));
      for (int r = k + 1; r < n; ++r) {
        const S factor = L(r, k) / L(k, k);
        L.row(r) -= factor * L.row(k);
        D_inverse_.row(r) -= factor * D_inverse_.row(k);
      }
    }
    for (int k = n - 1; k >= 0; --k) {
      const S inverse = 1 / L(k, k);
      for (int c = k + 1; c < n; ++c) {
        const S factor = L(k, c);
        D_inverse_.row(k) -= factor * D_inverse_.row(c);
      }
      D_inverse_.row(k) *= inverse;
    }
    return good;
  }

  bool has_nearly_dependent_rows_ = false;
  Matrix6<S> Y_, V_, rest_;
  Vector6<S> inverse_size_;  ///< inverse of M's diagonal; 0 where the diagonal counts as zero
  Motion H_, U_;
  Block D_inverse_;
  Free q_;
  Vector6<S> f_, a_;
};

}  // namespace trivium
