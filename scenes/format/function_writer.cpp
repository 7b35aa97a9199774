#include "scenes/format/function_writer.hpp"

#include <variant>
#include <vector>

namespace trivium::scenes {
namespace {

class FunctionWriter {
 public:
  Json operator()(double constant) const { return constant; }
  Json operator()(const TimeFunction::Polynomial& f) const {
    return Json::Object{{"kind", "polynomial"}, {"coefficients", numbers(f.coefficients)}};
  }
  Json operator()(const TimeFunction::Harmonic& f) const {
    return Json::Object{{"kind", "harmonic"},
                        {"offset", f.offset},
                        {"amplitude", f.amplitude},
                        {"angular_frequency", f.angular_frequency},
                        {"phase", f.phase}};
  }
  Json operator()(const TimeFunction::Sin& f) const {
    return Json::Object{{"kind", "sin"}, {"of", argument(f.of)}};
  }
  Json operator()(const TimeFunction::Cos& f) const {
    return Json::Object{{"kind", "cos"}, {"of", argument(f.of)}};
  }
  Json operator()(const TimeFunction::Sum& f) const {
    return Json::Object{{"kind", "sum"}, {"terms", functions(f.terms)}};
  }
  Json operator()(const TimeFunction::Product& f) const {
    return Json::Object{{"kind", "product"}, {"factors", functions(f.factors)}};
  }
  Json operator()(const TimeFunction::Step5& f) const {
    return Json::Object{{"kind", "step5"}, {"t0", f.t0}, {"f0", f.f0}, {"t1", f.t1}, {"f1", f.f1}};
  }
  Json operator()(const TimeFunction::Piecewise& f) const {
    return Json::Object{{"kind", "piecewise"}, {"times", numbers(f.times)}, {"pieces", functions(f.pieces)}};
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
