#pragma once
/// The public interface of Trivium in one header: read or build a scene, check and solve its state, simulate
/// its motion, and compare formulations. The library behind it is compiled; link trivium::trivium. Programs
/// that need the templates themselves link trivium::templates (docs/library.md). All quantities are in SI
/// units. Every error is a trivium::Error (base/error.hpp), which carries its kind, place and time.
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
