/// Makes the model of a scene once. If that fails, the error is thrown where the model is requested.

#include "validation/harness/named_scene.hpp"

#include <utility>

#include "base/error.hpp"
#include "scenes/make_mechanism.hpp"

namespace trivium {

NamedScene::NamedScene(std::string source_, scenes::Scene scene_, double t_)
    : source(std::move(source_)), scene(std::move(scene_)), t(t_) {
  try {
    model_ = make_model<double>(scene, t);
  } catch (const ModelError& error) {
    refusal_ = error.what();
  }
}

const Model<double>& NamedScene::model() const {
  if (!model_) throw ModelError(refusal_);
  return *model_;
}

}  // namespace trivium
