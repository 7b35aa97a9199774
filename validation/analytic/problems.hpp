#pragma once
/// The problems with known solutions: a file each. Closed forms, most of them by Jacobi's elliptic functions,
/// and curves of MSC ADAMS.

#include "validation/analytic/problem.hpp"

namespace trivium::analytic {

// pendulums.cpp
void pendulum(const std::string& formulation, Errors& errors);
/// A body on a revolute, or on a universal joint that it turns in about one axis, released from the
/// horizontal; `side` is where its centre was then.
void physical_pendulum(const std::string& name, const Vector& side, const std::string& formulation,
                       Errors& errors);

// free_body.cpp
void free_body(const std::string& name, const std::string& formulation, Errors& errors);

// heavy_top.cpp
/// The axis nutates with the period of its elliptic functions.
void heavy_top(const std::string& formulation, Errors& errors);
/// The same top where it precesses evenly: horizontal, Omega = m g l / (J n).
void steady_precession(const std::string& formulation, Errors& errors);

// four_bars.cpp
void four_bars(const std::string& formulation, Errors& errors);

// adams_curves.cpp
/// Against the curves of MSC ADAMS; `looser`: how much more is granted than to most of them.
void adams(const std::string& name, double looser, const std::string& formulation, Errors& errors);

/// All of them, in the order in which they are reported.
std::vector<Problem> problems();

}  // namespace trivium::analytic
