#pragma once
/// A scene that a validation works on, with its model in double. The model is made once, where the scene is
/// read; runs, formulations and comparisons take it from here.

#include <optional>
#include <string>
#include <utility>

#include "mechanism/model.hpp"
#include "scenes/scene.hpp"

namespace trivium {

class NamedScene {
 public:
  /// The state is that at time t. A scene that is refused has no model, and says so when asked for it.
  NamedScene(std::string source_, scenes::Scene scene_, double t_);
  NamedScene(std::string source_, scenes::Scene scene_, Model<double> made)
      : source(std::move(source_)), scene(std::move(scene_)), t(made.state.t), model_(std::move(made)) {}

  std::string source;  ///< the path or name that it was asked for by, which messages about it carry
  scenes::Scene scene;
  double t;

  /// Throws the ModelError with which the scene was refused.
  const Model<double>& model() const;

 private:
  std::optional<Model<double>> model_;
  std::string refusal_;
};

}  // namespace trivium
