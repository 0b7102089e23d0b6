#pragma once
// Mass and uniform loads of an element of constant material length. They apply to each world component alike.

#include "engine/math/vector.h"

namespace netpocket {

// Consistent mass int rhoA S^T S dp. Units by row and column: kg, kg m and kg m^2. Gerstmayr & Shabana (2006).
Eigen::Matrix4d consistent_mass(double mass_per_length, double length);

// Diagonal mass: the diagonal of the consistent mass, scaled so that the positions carry the mass of the element.
// Hinton, Rock & Zienkiewicz (1976), Earthquake Engineering & Structural Dynamics 4.
NodalWeights lumped_mass(double mass_per_length, double length);

// int S dp: generalised forces of a uniform load of 1 N/m, e.g. gravity.
NodalWeights uniform_load(double length);

}  // namespace netpocket
