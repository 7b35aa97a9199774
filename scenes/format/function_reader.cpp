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

/// The `of` of a sine or cosine.
std::vector<TimeFunction> read_argument(const Json& json, const Path& at) {
  std::vector<TimeFunction> of(1);
  scenes::read_value(json, at / "of", of.front());
  return of;
}

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
  const auto list = [&](std::string_view key, auto& values) {
    read_value(*object.find(key), at / key, values);
  };
  switch (kind + 1) {  // the plain number comes first among the kinds
    case 1: {
      TimeFunction::Polynomial f;
      list("coefficients", f.coefficients);
      out = std::move(f);
      break;
    }
    case 2: {
      TimeFunction::Harmonic f;
      object.read("offset", f.offset);
      object.read("amplitude", f.amplitude);
      object.read("angular_frequency", f.angular_frequency);
      object.read("phase", f.phase);
      out = f;
      break;
    }
    case 3:
      out = TimeFunction::Sin{read_argument(*object.find("of"), at)};
      break;
    case 4:
      out = TimeFunction::Cos{read_argument(*object.find("of"), at)};
      break;
    case 5: {
      TimeFunction::Sum f;
      list("terms", f.terms);
      out = std::move(f);
      break;
    }
    case 6: {
      TimeFunction::Product f;
      list("factors", f.factors);
      out = std::move(f);
      break;
    }
    case 8: {
      TimeFunction::Piecewise f;
      list("times", f.times);
      list("pieces", f.pieces);
      out = std::move(f);
      break;
    }
    default: {
      TimeFunction::Step5 f;
      object.read("t0", f.t0);
      object.read("f0", f.f0);
      object.read("t1", f.t1);
      object.read("f1", f.f1);
      out = f;
    }
  }
}

}  // namespace trivium::scenes
