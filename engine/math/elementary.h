#pragma once
// Elementary functions that give the same bits on every processor. The C library selects variants by the features of
// the processor, and these differ in the last bit. The functions here use only +, -, *, / and square roots in a fixed
// order; IEEE 754 prescribes their results. All code of a step and of the set-up of a model must use these functions.
//
// Errors against the exact value, in units in the last place (tests/engine/math): below 1 for sine, cosine, cube_root
// and fifth_root, below 1.5 for arc_tangent and hypotenuse. Pure functions: any thread may call them.

#include <cmath>

namespace netpocket {

// Sine and cosine of an angle (rad). The error bound holds up to 1e5 rad; a larger angle is first taken modulo the
// double nearest to 2 pi. NaN if the angle is not finite.
double sine(double angle);
double cosine(double angle);

// The angle (rad, -pi to pi) of the point (x, y), as std::atan2. NaN if x or y is not finite.
double arc_tangent(double y, double x);

// Real cube root and fifth root of any finite number whose root is a normal number.
double cube_root(double x);
double fifth_root(double x);

// sqrt(x^2 + y^2), for numbers whose squares neither overflow nor underflow.
inline double hypotenuse(double x, double y) { return std::sqrt(x * x + y * y); }

// x^4.
inline double fourth_power(double x) { return (x * x) * (x * x); }

}  // namespace netpocket
