#pragma once
/// The list of the problems with known solutions; each source file holds one kind. Most solutions are closed
/// forms with Jacobi's elliptic functions; the others are curves of MSC ADAMS.

#include "validation/analytic/problem.hpp"

namespace trivium::analytic {

// pendulums.cpp
void pendulum(const std::string& formulation, Errors& errors);
/// A body on a revolute, or on a universal joint that turns about one axis only, released from rest at the
/// horizontal. `side` is the direction from the joint to the centre of mass at the release.
void physical_pendulum(const std::string& name, const Vector& side, const std::string& formulation,
                       Errors& errors);

// free_body.cpp
void free_body(const std::string& name, const std::string& formulation, Errors& errors);

// heavy_top.cpp
/// The height of the centre of mass is periodic with the nutation period given by elliptic functions; the
/// spin is constant.
void heavy_top(const std::string& formulation, Errors& errors);
/// The same top in steady precession: its axis is horizontal and precesses at Omega = m g l / (J n).
void steady_precession(const std::string& formulation, Errors& errors);

// four_bars.cpp
void four_bars(const std::string& formulation, Errors& errors);

// adams_curves.cpp
/// Compares with curves of MSC ADAMS; the bounds of most quantities are widened by the factor `looser`.
void adams(const std::string& name, double looser, const std::string& formulation, Errors& errors);

/// All problems, in the order in which they are reported.
std::vector<Problem> problems();

}  // namespace trivium::analytic
