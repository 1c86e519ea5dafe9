#pragma once

#include <cmath>
#include <cstdlib>
#include <limits>

#include "tf2/visibility_control.h"

using tf2Scalar = double;

constexpr tf2Scalar TF2SIMD_PI = 3.14159265358979323846;
constexpr tf2Scalar TF2SIMD_2_PI = 2 * TF2SIMD_PI;
constexpr tf2Scalar TF2SIMD_HALF_PI = TF2SIMD_PI / 2;
constexpr tf2Scalar TF2SIMD_RADS_PER_DEG = TF2SIMD_2_PI / 360;
constexpr tf2Scalar TF2SIMD_DEGS_PER_RAD = 360 / TF2SIMD_2_PI;
constexpr tf2Scalar TF2SIMD_EPSILON = std::numeric_limits<tf2Scalar>::epsilon();
constexpr tf2Scalar TF2SIMD_INFINITY = std::numeric_limits<tf2Scalar>::max();

inline tf2Scalar tf2Radians(tf2Scalar degrees) {return degrees * TF2SIMD_RADS_PER_DEG;}
inline tf2Scalar tf2Degrees(tf2Scalar radians) {return radians * TF2SIMD_DEGS_PER_RAD;}
inline tf2Scalar tf2Sqrt(tf2Scalar x) {return std::sqrt(x);}
inline tf2Scalar tf2Fabs(tf2Scalar x) {return std::fabs(x);}
inline tf2Scalar tf2Sin(tf2Scalar x) {return std::sin(x);}
inline tf2Scalar tf2Cos(tf2Scalar x) {return std::cos(x);}
inline tf2Scalar tf2Tan(tf2Scalar x) {return std::tan(x);}
/// Of numbers a little outside of [-1, 1], too.
inline tf2Scalar tf2Acos(tf2Scalar x) {return std::acos(x < -1 ? -1 : x > 1 ? 1 : x);}
inline tf2Scalar tf2Asin(tf2Scalar x) {return std::asin(x < -1 ? -1 : x > 1 ? 1 : x);}
inline tf2Scalar tf2Atan(tf2Scalar x) {return std::atan(x);}
inline tf2Scalar tf2Atan2(tf2Scalar y, tf2Scalar x) {return std::atan2(y, x);}
inline tf2Scalar tf2Pow(tf2Scalar x, tf2Scalar y) {return std::pow(x, y);}
inline bool tf2FuzzyZero(tf2Scalar x) {return std::fabs(x) < TF2SIMD_EPSILON;}
