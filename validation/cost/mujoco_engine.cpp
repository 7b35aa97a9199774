/// Passes a scene to MuJoCo as text in memory, and reads accelerations after its forward dynamics.

#include "validation/cost/mujoco_engine.hpp"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstring>

#include "scenes/make_mechanism.hpp"
#include "validation/cost/mujoco_text.hpp"

namespace trivium::cost {

namespace {

/// Replaces MuJoCo's error handler, which would end the program.
void throw_error(const char* message) { throw std::runtime_error(message); }
void ignore_warning(const char*) {}

struct Free {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
  void operator()(mjVFS* files) const {
    mj_deleteVFS(files);
    delete files;
  }
};

using Model = std::unique_ptr<mjModel, Free>;

Model read_model(const std::vector<TextFile>& texts) {
  std::unique_ptr<mjVFS, Free> files(new mjVFS);
  mj_defaultVFS(files.get());
  for (const TextFile& file : texts) {
    if (mj_makeEmptyFileVFS(files.get(), file.name.c_str(), static_cast<int>(file.text.size())) != 0)
      throw NotTaken("its in-memory file system is full");
    const int k = mj_findFileVFS(files.get(), file.name.c_str());
    std::memcpy(files->filedata[k], file.text.data(), file.text.size());
  }
  char error[1000] = "";
  Model model(mj_loadXML(texts.front().name.c_str(), files.get(), error, sizeof error));
  if (!model) throw std::runtime_error(error);
  return model;
}

class Mujoco : public MujocoEngine {
 public:
  explicit Mujoco(const PeerScene& scene)
      : gravity_(scene.gravity), model_(read_model(mujoco_files(scene))), data_(mj_makeData(model_.get())) {
    for (std::size_t b = 0; b < scene.model.bodies.size(); ++b)
      body_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, fmt::format("b{}", b).c_str()));
    const std::vector<double> rates = mujoco_velocities(scene);
    if (static_cast<int>(rates.size()) != model_->nv)
      throw std::runtime_error("its number of velocities differs from the scene's");
    std::copy(rates.begin(), rates.end(), data_->qvel);
    for (std::size_t b = 0; b < scene.loads.size(); ++b) {
      mjtNum* load = data_->xfrc_applied + 6 * body_[b];
      std::copy(scene.loads[b].force.begin(), scene.loads[b].force.end(), load);
      std::copy(scene.loads[b].torque.begin(), scene.loads[b].torque.end(), load + 3);
    }
  }

  void evaluate() override { mj_forward(model_.get(), data_.get()); }

  /// Throws MuJoCo's warnings: after a warning, MuJoCo continues with a modified system.
  void throw_warnings() const {
    for (int k = 0; k < mjNWARNING; ++k)
      if (data_->warning[k].number > 0)
        throw std::runtime_error(mju_warningText(k, data_->warning[k].lastinfo));
  }

  std::vector<Vector3> r_ddot() override {
    throw_warnings();
    mj_rnePostConstraint(model_.get(), data_.get());
    std::vector<Vector3> r_ddot;
    for (const int b : body_) {
      mjtNum a[6];  // angular, then linear acceleration; gravity is subtracted, and added again below
      mj_objectAcceleration(model_.get(), data_.get(), mjOBJ_BODY, b, a, 0);
      r_ddot.push_back({a[3] + gravity_[0], a[4] + gravity_[1], a[5] + gravity_[2]});
    }
    return r_ddot;
  }

  void set_state(std::span<const double> qpos, std::span<const double> qvel) override {
    std::copy(qpos.begin(), qpos.end(), data_->qpos);
    std::copy(qvel.begin(), qvel.end(), data_->qvel);
  }

 private:
  Vector3 gravity_;
  Model model_;
  std::unique_ptr<mjData, Free> data_;
  std::vector<int> body_;  ///< MuJoCo's index of each body of the scene
};

/// The number of entries of MuJoCo's mass matrix: each degree of freedom has one entry with each of its
/// ancestors.
double mass_matrix_entries(const PeerScene& scene) {
  std::vector<double> freedoms(scene.tree.size());
  double entries = 0;
  for (const TreeJoint& branch : scene.tree) {
    const double own = branch.kind == TreeJoint::Kind::free   ? 6
                       : branch.kind == TreeJoint::Kind::ball ? 3
                                                              : static_cast<double>(branch.axes.size());
    const double below = branch.parent == ground ? 0 : freedoms[static_cast<std::size_t>(branch.parent)];
    freedoms[static_cast<std::size_t>(branch.body)] = below + own;
    entries += own * (below + own);
  }
  return entries;
}

}  // namespace

std::unique_ptr<MujocoEngine> mujoco_engine_with_states(const PeerScene& scene) {
  if (mass_matrix_entries(scene) > 1e7) throw NotTaken("its mass matrix is full: minutes an evaluation");
  mju_user_error = throw_error;
  mju_user_warning = ignore_warning;
  return std::make_unique<Mujoco>(scene);
}

std::unique_ptr<Engine> mujoco_engine(const PeerScene& scene) { return mujoco_engine_with_states(scene); }

}  // namespace trivium::cost
