/// A scene that is built in C++ keeps its parts as JSON text, which the reader of scene files parses at the
/// first use. Built scenes therefore pass the same checks as files, without a second implementation.

#include "trivium/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <mutex>
#include <utility>

#include "base/error.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/format/json.hpp"
#include "scenes/format/scene_checks.hpp"
#include "scenes/format/scene_file.hpp"
#include "trivium/scene_contents.hpp"

namespace trivium {

namespace {

std::string json_text(std::string_view text) { return scenes::print_json(text, scenes::Path("text")); }

void require_time(const std::string& source, double t) {
  if (!std::isfinite(t))
    throw Error(ErrorKind::input, Place{source},
                fmt::format("the time of the state is {}; accepted: a finite time", t));
}

/// JSON text of a number. JSON has no NaN or infinity: such a value becomes a string, which the reader of the
/// scene rejects with the place of the value.
std::string number(double x) { return std::isfinite(x) ? scenes::shortest(x) : fmt::format("\"{}\"", x); }

std::string joined(char open, const std::vector<std::string>& parts, char close) {
  return fmt::format("{}{}{}", open, fmt::join(parts, ", "), close);
}

std::string numbers(const double* first, std::size_t count) {
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < count; ++k) parts.push_back(number(first[k]));
  return joined('[', parts, ']');
}

/// JSON text of an object. Keys without a value are left out.
class Object {
 public:
  Object& add(std::string_view key, const Value& value) {
    if (!value.json().empty()) parts_.push_back(json_text(key) + ": " + value.json());
    return *this;
  }
  Object& add(std::string_view key, const Object& object) {
    parts_.push_back(json_text(key) + ": " + object.json());
    return *this;
  }
  Object& add(Keys keys) {
    for (const Key& key : keys) add(key.name, key.value);
    return *this;
  }
  std::string json() const { return joined('{', parts_, '}'); }

 private:
  std::vector<std::string> parts_;
};

Object side(const Side& s) {
  return Object()
      .add("body", s.body)
      .add("point", s.point)
      .add("vector", s.vector)
      .add("axis", s.axis)
      .add("x", s.x);
}

}  // namespace

Value::Value(double x) : json_(number(x)) {}
Value::Value(bool flag) : json_(flag ? "true" : "false") {}
Value::Value(std::string_view text) : json_(json_text(text)) {}
Value::Value(const Components& vector) : json_(numbers(vector.data(), vector.size())) {}
Value::Value(std::initializer_list<double> list) : json_(numbers(list.begin(), list.size())) {}
Value::Value(Keys keys) : json_(Object().add(keys).json()) {}

Value list(std::initializer_list<Value> values) {
  std::vector<std::string> parts;
  for (const Value& value : values) parts.push_back(value.json());
  Value all;
  all.json_ = joined('[', parts, ']');
  return all;
}

/// A scene under construction: the JSON text of every part.
struct Scene::Parts {
  std::string name, description, reference;
  double t = 0, rank_tolerance = standard_rank_tolerance;
  std::vector<std::string> bodies, constraints, effects;

  /// Parses and checks the parts at the first call; later calls, from any thread, return the same contents.
  const Contents& contents() const;

  std::string json() const {
    const auto array = [](const std::vector<std::string>& parts) {
      return fmt::format("[\n{}\n]", fmt::join(parts, ",\n"));
    };
    const auto text = [](const char* key, const std::string& value) {
      return value.empty() ? std::string() : fmt::format(R"("{}": {}, )", key, json_text(value));
    };
    return fmt::format(R"({{"trivium": 1, "name": {}, {}{}"bodies": {}, "constraints": {}, "effects": {}}})",
                       json_text(name), text("description", description), text("reference", reference),
                       array(bodies), array(constraints), array(effects));
  }

 private:
  mutable std::once_flag once_;
  mutable std::shared_ptr<const Contents> read_;
};

Scene::Scene(std::string name, double t) {
  auto parts = std::make_shared<Parts>();
  parts->name = std::move(name);
  parts->t = t;
  parts_ = std::move(parts);
}

Scene::Parts& Scene::parts() {
  // Copies of a scene share their parts until one of them changes, so a change begins with a copy. A scene
  // that was read is first split into the JSON text of its parts.
  require_parts();
  auto own = std::make_shared<Parts>();
  if (parts_) {
    own->name = parts_->name;
    own->description = parts_->description;
    own->reference = parts_->reference;
    own->t = parts_->t;
    own->rank_tolerance = parts_->rank_tolerance;
    own->bodies = parts_->bodies;
    own->constraints = parts_->constraints;
    own->effects = parts_->effects;
  } else {
    const scenes::Json all = scenes::parse_json(scenes::write_scene(contents_->scene), scenes::Path("scene"));
    own->name = contents_->scene.name;
    own->description = contents_->scene.description;
    own->reference = contents_->scene.reference;
    own->t = contents_->t;
    own->rank_tolerance = contents_->scene.rank_tolerance;
    for (const auto& [key, value] : *all.object()) {
      if (!value.array()) continue;
      auto& into = key == "bodies" ? own->bodies : key == "constraints" ? own->constraints : own->effects;
      for (const scenes::Json& part : *value.array())
        into.push_back(scenes::print_json(part, scenes::Path("scene")));
    }
  }
  contents_.reset();
  parts_ = own;
  return *own;
}

Scene& Scene::add_body(const Body& body) {
  Object object;
  object.add("name", body.name)
      .add("mass", body.mass)
      .add("inertia", body.inertia)
      .add("position", body.position)
      .add("orientation", body.orientation)
      .add("velocity", body.velocity)
      .add("angular_velocity", body.angular_velocity);
  if (body.unphysical_inertia) object.add("unphysical_inertia", true);
  parts().bodies.push_back(object.json());
  return *this;
}

Scene& Scene::add_constraint(std::string_view type, std::string_view name, const Side& i, const Side& j,
                             Keys more) {
  parts().constraints.push_back(
      Object().add("type", type).add("name", name).add("i", side(i)).add("j", side(j)).add(more).json());
  return *this;
}

Scene& Scene::add_effect(std::string_view type, Keys keys) {
  parts().effects.push_back(Object().add("type", type).add(keys).json());
  return *this;
}

const Scene::Contents& Scene::Parts::contents() const {
  std::call_once(once_, [&] {
    const std::string source = fmt::format("scene \"{}\"", scenes::printable(name));
    require_time(source, t);
    scenes::Scene scene = scenes::parse_scene(json(), source);
    scenes::check_functions(scene, t, scenes::Path(source));
    scene.rank_tolerance = rank_tolerance;
    read_ = std::make_shared<const Contents>(Contents{std::move(scene), t, source});
  });
  return *read_;
}

void Scene::require_parts() const {
  if (!parts_ && !contents_) throw Error(ErrorKind::input, "a scene that was moved from has no parts");
}

const Scene::Contents& Scene::contents() const {
  require_parts();
  return contents_ ? *contents_ : parts_->contents();
}

Scene& Scene::set_rank_tolerance(double tolerance) {
  if (!(tolerance >= least_rank_tolerance && tolerance <= largest_rank_tolerance))
    throw Error(ErrorKind::input, fmt::format("the rank tolerance is {}; accepted: {} to {}", tolerance,
                                              least_rank_tolerance, largest_rank_tolerance));
  if (parts_) {
    parts().rank_tolerance = tolerance;
  } else {
    require_parts();
    auto own = std::make_shared<Contents>(*contents_);
    own->scene.rank_tolerance = tolerance;
    contents_ = std::move(own);
  }
  return *this;
}

double Scene::t() const { return contents().t; }

std::vector<std::string> Scene::bodies() const {
  std::vector<std::string> names;
  for (const scenes::Body& body : contents().scene.bodies) names.push_back(body.name);
  return names;
}

std::vector<std::string> Scene::constraints() const {
  std::vector<std::string> names;
  for (const scenes::Constraint& constraint : contents().scene.constraints) names.push_back(constraint.name);
  return names;
}

void Scene::write(const std::filesystem::path& file) const {
  scenes::write_scene_file(file, contents().scene);
}

Scene read_scene(const std::string& path_or_name, std::optional<double> t,
                 const std::filesystem::path& header) {
  if (t) require_time(path_or_name, *t);
  scenes::Scene scene = load_scene(path_or_name, t, header);
  const double at = scenes::time_of(scene, t);
  return Scene(std::make_shared<const Scene::Contents>(Scene::Contents{std::move(scene), at, path_or_name}));
}

std::vector<std::string> catalogue_scenes(const std::filesystem::path& header) {
  std::vector<std::string> names;
  for (const auto& file : catalogue(header)) names.push_back(file.stem().string());
  return names;
}

}  // namespace trivium
