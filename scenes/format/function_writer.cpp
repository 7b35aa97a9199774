#include "scenes/format/function_writer.hpp"

#include <variant>
#include <vector>

namespace trivium::scenes {
namespace {

class FunctionWriter {
 public:
  Json operator()(double constant) const { return constant; }
  Json operator()(const TimeFunction::Polynomial& f) const {
    return object_of(Member{"kind", "polynomial"}, Member{"coefficients", numbers(f.coefficients)});
  }
  Json operator()(const TimeFunction::Harmonic& f) const {
    return object_of(Member{"kind", "harmonic"}, Member{"offset", f.offset}, Member{"amplitude", f.amplitude},
                     Member{"angular_frequency", f.angular_frequency}, Member{"phase", f.phase});
  }
  Json operator()(const TimeFunction::Sin& f) const {
    return object_of(Member{"kind", "sin"}, Member{"of", argument(f.of)});
  }
  Json operator()(const TimeFunction::Cos& f) const {
    return object_of(Member{"kind", "cos"}, Member{"of", argument(f.of)});
  }
  Json operator()(const TimeFunction::Sum& f) const {
    return object_of(Member{"kind", "sum"}, Member{"terms", functions(f.terms)});
  }
  Json operator()(const TimeFunction::Product& f) const {
    return object_of(Member{"kind", "product"}, Member{"factors", functions(f.factors)});
  }
  Json operator()(const TimeFunction::Step5& f) const {
    return object_of(Member{"kind", "step5"}, Member{"t0", f.t0}, Member{"f0", f.f0}, Member{"t1", f.t1},
                     Member{"f1", f.f1});
  }
  Json operator()(const TimeFunction::Piecewise& f) const {
    return object_of(Member{"kind", "piecewise"}, Member{"times", numbers(f.times)},
                     Member{"pieces", functions(f.pieces)});
  }

 private:
  static Json numbers(const std::vector<double>& items) { return Json::Array(items.begin(), items.end()); }
  static Json functions(const std::vector<TimeFunction>& items) {
    Json::Array array;
    array.reserve(items.size());
    for (const TimeFunction& item : items) array.push_back(to_json(item));
    return array;
  }
  static Json argument(const std::vector<TimeFunction>& of) {
    return std::visit(FunctionWriter{}, of.front().kind());
  }
};

}  // namespace

Json to_json(const TimeFunction& f) { return std::visit(FunctionWriter{}, f.kind()); }

}  // namespace trivium::scenes
