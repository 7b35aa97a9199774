/// Reads functions of time from JSON (declared in json_reader.hpp).

#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/variants.hpp"
#include "scenes/format/json_reader.hpp"

namespace trivium::scenes {
namespace {

void read_value(const Json& json, const Path& at, std::vector<double>& out) {
  const Json::Array& items = read_items(json, at, "numbers");
  out.resize(items.size());
  for (std::size_t k = 0; k < items.size(); ++k) scenes::read_value(items[k], at / k, out[k]);
}

void read_value(const Json& json, const Path& at, std::vector<TimeFunction>& out) {
  const Json::Array& items = read_items(json, at, "functions of time");
  out.resize(items.size());
  for (std::size_t k = 0; k < items.size(); ++k) scenes::read_value(items[k], at / k, out[k]);
}

/// Reads the key `of`, the argument of a sine or cosine.
std::vector<TimeFunction> read_argument(const Json& json, const Path& at) {
  std::vector<TimeFunction> of(1);
  scenes::read_value(json, at / "of", of.front());
  return of;
}

/// Visitor that reads the parts of a function of each kind.
struct PartReader {
  const ObjectReader& object;
  const Path& at;

  void operator()(double&) const {}
  void operator()(TimeFunction::Polynomial& f) const { list("coefficients", f.coefficients); }
  void operator()(TimeFunction::Harmonic& f) const {
    object.read("offset", f.offset);
    object.read("amplitude", f.amplitude);
    object.read("angular_frequency", f.angular_frequency);
    object.read("phase", f.phase);
  }
  void operator()(TimeFunction::Sin& f) const { f.of = read_argument(*object.find("of"), at); }
  void operator()(TimeFunction::Cos& f) const { f.of = read_argument(*object.find("of"), at); }
  void operator()(TimeFunction::Sum& f) const { list("terms", f.terms); }
  void operator()(TimeFunction::Product& f) const { list("factors", f.factors); }
  void operator()(TimeFunction::Step5& f) const {
    object.read("t0", f.t0);
    object.read("f0", f.f0);
    object.read("t1", f.t1);
    object.read("f1", f.f1);
  }
  void operator()(TimeFunction::Piecewise& f) const {
    list("times", f.times);
    list("pieces", f.pieces);
  }

 private:
  void list(std::string_view key, auto& values) const { read_value(*object.find(key), at / key, values); }
};

}  // namespace

void read_value(const Json& json, const Path& at, TimeFunction& out) {
  if (const double* constant = json.number()) {
    out = *constant;
    return;
  }
  if (!json.object())
    fail_type(json, at, "a number or an object with a kind, such as {\"kind\": \"sin\", \"of\": 1}");
  const std::size_t kind = read_tag(json, at, "kind", "kind", names_of(function_shapes));
  const ObjectReader object(json, at, function_shapes[kind]);
  // index 0 of TimeFunction::Kind is the plain number, which has no shape
  TimeFunction::Kind parts = emplaced<TimeFunction::Kind>(kind + 1);
  std::visit(PartReader{object, at}, parts);
  std::visit([&](auto& f) { out = std::move(f); }, parts);
}

}  // namespace trivium::scenes
