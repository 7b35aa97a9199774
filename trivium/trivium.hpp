#pragma once
/// Trivium's front door: scenes, their states and their motions, in three formulations of the equations of
/// motion. All of it is compiled once; who wants the templates themselves takes trivium::templates
/// (docs/library.md).
///
///     trivium::Scene scene = trivium::read_scene("four_bar");
///     trivium::Solution at = trivium::solve(scene, {.formulation = "r-p"});
///     trivium::Motion motion = trivium::simulate(scene, {.integrator = "radau5", .end = 2});

#include "base/error.hpp"
#include "trivium/compare.hpp"
#include "trivium/instant.hpp"
#include "trivium/scene.hpp"
#include "trivium/simulate.hpp"
#include "trivium/solve.hpp"
