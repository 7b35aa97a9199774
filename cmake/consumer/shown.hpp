#pragma once
/// Variables that the C++ blocks in README and docs/ use without defining them: a scene's mechanism and
/// state, one of its bodies, and four copies. Used by the programs that cmake/docs_programs.cmake generates
/// from these blocks.

#include <formulations/equations_of_motion_impl.hpp>
#include <formulations/printed/augmented_solver.hpp>
#include <formulations/r_omega.hpp>
#include <formulations/r_p.hpp>
#include <formulations/side_by_side.hpp>
#include <formulations/structured/acceleration_solver_impl.hpp>
#include <formulations/structured/graph_solver_impl.hpp>
#include <mechanism/mechanism_batch.hpp>
#include <mechanism/state_batch.hpp>
#include <scenes/format/scene_file.hpp>
#include <scenes/make_mechanism.hpp>
#include <simulation/simulate.hpp>
#include <trivium/trivium.hpp>

#include <array>
#include <filesystem>

struct Shown {
  std::filesystem::path path;
  trivium::Mechanism<double> mechanism;
  trivium::MechanismState<double> state;
  int b = 0;
  std::array<trivium::Mechanism<double>, 4> four_mechanisms;
  std::array<trivium::MechanismState<double>, 4> four_states;
};

inline Shown show(const char* path) {
  const auto [mechanism, state] = trivium::make_model<double>(trivium::scenes::read_scene_file(path));
  return {
      path, mechanism, state, 0, {mechanism, mechanism, mechanism, mechanism}, {state, state, state, state}};
}

void use(const auto&...) {}
