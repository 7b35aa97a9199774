#pragma once
/// A scene that a validation program works on, with its model in double. The model is made once, when the
/// scene is read, and is shared by all runs, formulations and comparisons.

#include <optional>
#include <string>
#include <utility>

#include "mechanism/model.hpp"
#include "scenes/scene.hpp"

namespace trivium {

class NamedScene {
 public:
  /// Makes the model of the scene at time t. If this fails, the scene has no model, and model() throws the
  /// reason.
  NamedScene(std::string source_, scenes::Scene scene_, double t_);
  NamedScene(std::string source_, scenes::Scene scene_, Model<double> made)
      : source(std::move(source_)), scene(std::move(scene_)), t(made.state.t), model_(std::move(made)) {}

  std::string source;  ///< path or name on the command line, for messages
  scenes::Scene scene;
  double t;

  /// The model. Throws the ModelError of the constructor if the scene has none.
  const Model<double>& model() const;

 private:
  std::optional<Model<double>> model_;
  std::string refusal_;
};

}  // namespace trivium
