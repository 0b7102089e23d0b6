#pragma once
// Elementary functions that give the same bits on every processor. The C library picks variants of its own by what the
// processor has, which differ in the last bit; these use only +, -, *, / and square roots, whose results IEEE 754
// prescribes, in a fixed order. Everything that a step or the set-up of a model reaches uses these.
//
// Errors against the exact value, in units in the last place (tests/engine/math): below 1 for sine, cosine, cube_root
// and fifth_root, below 1.5 for arc_tangent and hypotenuse. Pure functions: any thread may call them.

#include <cmath>

namespace netpocket {

// Of an angle (rad). The error bound holds up to 1e5 rad; beyond, the angle is first taken modulo the double nearest
// to 2 pi. Not a number for what is not finite.
double sine(double angle);
double cosine(double angle);

// The angle (rad, -pi to pi) of the point (x, y), as std::atan2.
double arc_tangent(double y, double x);

// Of any finite number; normal results only.
double cube_root(double x);
double fifth_root(double x);

// sqrt(x^2 + y^2), for numbers whose squares are neither too large nor too small.
inline double hypotenuse(double x, double y) { return std::sqrt(x * x + y * y); }

// x^4.
inline double fourth_power(double x) { return (x * x) * (x * x); }

}  // namespace netpocket
