#pragma once
/// The families of hard cases. A case has its difficulty as an argument: the command line can ask for any
/// value. Each source file of validation/hard holds one family.

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "validation/hard/judge.hpp"

namespace trivium::hard {

/// The difficulties that a case takes.
struct Accepted {
  double least, most;
  bool is_count = false;  ///< whole numbers only

  bool includes(double difficulty) const {
    return difficulty >= least && difficulty <= most && !(is_count && difficulty != std::round(difficulty));
  }
};

/// A kind of case.
struct Case {
  std::string name;
  std::string difficulty;  ///< what its argument is, with its unit
  Accepted accepted;
  double easy = 0;                   ///< difficulty of its twin, which must survive without a warning
  std::vector<double> quick, whole;  ///< difficulties of --quick, and of the whole suite
  std::function<void(Judge&, double)> judge;
  /// The scene at this difficulty, for other programs; empty if a case has several.
  std::function<scenes::Scene(double)> scene = {};
};

struct Family {
  std::string name, about;
  std::vector<Case> cases;
};

Family gimbal_lock();
Family spin();
Family inertia();
Family redundancy();
Family singular_positions();
Family long_runs();
Family stiff();
Family drivers();
Family size_and_place();
/// The cases of size_and_place with many bodies.
std::vector<Case> large_mechanisms();
Family locked();
Family faults();

/// All of them, in the order in which they are reported.
std::vector<Family> families();

}  // namespace trivium::hard
