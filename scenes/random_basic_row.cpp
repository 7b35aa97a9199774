#include "scenes/random_basic_row.hpp"

#include <string_view>

#include "base/variants.hpp"
#include "constraints/constraint_row.hpp"
#include "constraints/plain_body.hpp"

namespace trivium::scenes {

namespace {

using V = RandomDraw::V;

/// Key visitor that draws a random value for every key of a basic constraint except f.
struct Drawing {
  RandomDraw& draw;
  const V &P, &Q, &x, &y;
  RandomBasicRow& out;
  V a = V::Zero();  ///< the vector of body i, in global components

  void vector_i(V& a_i) {
    a = a_i = draw.vector(2) + x;
    out.i.vector = plain(a_i);
  }
  void vector_j(V& a_j) {
    const auto is_along_a = [&] { return a.cross(a_j).norm() < far_from_singular * a.norm() * a_j.norm(); };
    do a_j = draw.vector(2) + y;
    while (is_along_a());
    out.j.vector = plain(a_j);
  }
  void point_i(V& s) {
    s = P;
    out.i.point = plain(s);
  }
  void point_j(V& s) {
    s = Q;
    out.j.point = plain(s);
  }
  void need(std::string_view, auto& value) { take(value); }
  void may(std::string_view, auto& value) { take(value); }

 private:
  void take(TimeFunction&) {}
  void take(V& direction) {
    direction = draw.vector(2);
    out.direction = plain(direction);
  }
};

}  // namespace

RandomBasicRow random_basic_row(ConstraintType type, RandomDraw& draw, double t, const V& P, const V& Q,
                                const V& x, const V& y) {
  RandomBasicRow out;
  auto row = emplaced<BasicConstraint<double>>(static_cast<std::size_t>(type.place));
  std::visit([&](auto& one) { one.keys(Drawing{draw, P, Q, x, y, out, V::Zero()}, one); }, row);
  const PlainBody<double> global;
  out.f = row_position(row, global, global, t);
  return out;
}

}  // namespace trivium::scenes
