#pragma once

#include "tf2/LinearMath/Scalar.h"

namespace tf2
{

/// Three coordinates. It begins as zero.
class Vector3
{
public:
  Vector3() = default;
  Vector3(const tf2Scalar & x, const tf2Scalar & y, const tf2Scalar & z) : m_floats{x, y, z, 0} {}

  const tf2Scalar & x() const {return m_floats[0];}
  const tf2Scalar & y() const {return m_floats[1];}
  const tf2Scalar & z() const {return m_floats[2];}
  const tf2Scalar & w() const {return m_floats[3];}
  const tf2Scalar & getX() const {return m_floats[0];}
  const tf2Scalar & getY() const {return m_floats[1];}
  const tf2Scalar & getZ() const {return m_floats[2];}
  void setX(tf2Scalar x) {m_floats[0] = x;}
  void setY(tf2Scalar y) {m_floats[1] = y;}
  void setZ(tf2Scalar z) {m_floats[2] = z;}
  void setW(tf2Scalar w) {m_floats[3] = w;}
  void setValue(const tf2Scalar & x, const tf2Scalar & y, const tf2Scalar & z) {*this = {x, y, z};}
  void setZero() {*this = {};}

  /// By index, too: v[2] is z.
  operator tf2Scalar *() {return m_floats;}
  operator const tf2Scalar *() const {return m_floats;}

  Vector3 & operator+=(const Vector3 & v) {return *this = {x() + v.x(), y() + v.y(), z() + v.z()};}
  Vector3 & operator-=(const Vector3 & v) {return *this = {x() - v.x(), y() - v.y(), z() - v.z()};}
  Vector3 & operator*=(const Vector3 & v) {return *this = {x() * v.x(), y() * v.y(), z() * v.z()};}
  Vector3 & operator*=(const tf2Scalar & s) {return *this = {x() * s, y() * s, z() * s};}
  Vector3 & operator/=(const tf2Scalar & s) {return *this = {x() / s, y() / s, z() / s};}

  bool operator==(const Vector3 & other) const
  {
    return x() == other.x() && y() == other.y() && z() == other.z() && w() == other.w();
  }
  bool operator!=(const Vector3 & other) const {return !(*this == other);}

  tf2Scalar dot(const Vector3 & v) const {return x() * v.x() + y() * v.y() + z() * v.z();}
  Vector3 cross(const Vector3 & v) const
  {
    return {y() * v.z() - z() * v.y(), z() * v.x() - x() * v.z(), x() * v.y() - y() * v.x()};
  }
  tf2Scalar triple(const Vector3 & v1, const Vector3 & v2) const {return dot(v1.cross(v2));}
  tf2Scalar length2() const {return dot(*this);}
  tf2Scalar length() const {return std::sqrt(length2());}
  tf2Scalar distance2(const Vector3 & v) const {return Vector3(*this).operator-=(v).length2();}
  tf2Scalar distance(const Vector3 & v) const {return std::sqrt(distance2(v));}
  tf2Scalar angle(const Vector3 & v) const {return tf2Acos(dot(v) / std::sqrt(length2() * v.length2()));}
  Vector3 & normalize() {return *this /= length();}
  Vector3 normalized() const {return Vector3(*this).normalize();}
  Vector3 absolute() const {return {std::fabs(x()), std::fabs(y()), std::fabs(z())};}
  /// Around an axis of length one.
  Vector3 rotate(const Vector3 & wAxis, tf2Scalar angle) const;

  /// From `v0`, where `rt` is 0, to `v1`, where it is 1.
  void setInterpolate3(const Vector3 & v0, const Vector3 & v1, tf2Scalar rt);
  Vector3 lerp(const Vector3 & v, const tf2Scalar & t) const;
  void setMax(const Vector3 & other);
  void setMin(const Vector3 & other);

  // Which coordinate it is: 0, 1 or 2.
  int minAxis() const {return x() < y() ? (x() < z() ? 0 : 2) : (y() < z() ? 1 : 2);}
  int maxAxis() const {return x() < y() ? (y() < z() ? 2 : 1) : (x() < z() ? 2 : 0);}
  int furthestAxis() const {return absolute().minAxis();}
  int closestAxis() const {return absolute().maxAxis();}

  bool isZero() const {return x() == 0 && y() == 0 && z() == 0;}
  bool fuzzyZero() const {return length2() < TF2SIMD_EPSILON;}

  tf2Scalar m_floats[4] = {};
};

inline Vector3 operator+(const Vector3 & v1, const Vector3 & v2) {return Vector3(v1) += v2;}
inline Vector3 operator-(const Vector3 & v1, const Vector3 & v2) {return Vector3(v1) -= v2;}
inline Vector3 operator-(const Vector3 & v) {return {-v.x(), -v.y(), -v.z()};}
inline Vector3 operator*(const Vector3 & v1, const Vector3 & v2) {return Vector3(v1) *= v2;}
inline Vector3 operator*(const Vector3 & v, const tf2Scalar & s) {return Vector3(v) *= s;}
inline Vector3 operator*(const tf2Scalar & s, const Vector3 & v) {return Vector3(v) *= s;}
inline Vector3 operator/(const Vector3 & v, const tf2Scalar & s) {return Vector3(v) /= s;}
inline Vector3 operator/(const Vector3 & v1, const Vector3 & v2)
{
  return {v1.x() / v2.x(), v1.y() / v2.y(), v1.z() / v2.z()};
}

inline tf2Scalar tf2Dot(const Vector3 & v1, const Vector3 & v2) {return v1.dot(v2);}
inline tf2Scalar tf2Distance(const Vector3 & v1, const Vector3 & v2) {return v1.distance(v2);}
inline tf2Scalar tf2Distance2(const Vector3 & v1, const Vector3 & v2) {return v1.distance2(v2);}
inline tf2Scalar tf2Angle(const Vector3 & v1, const Vector3 & v2) {return v1.angle(v2);}
inline Vector3 tf2Cross(const Vector3 & v1, const Vector3 & v2) {return v1.cross(v2);}
inline Vector3 lerp(const Vector3 & v1, const Vector3 & v2, const tf2Scalar & t) {return v1.lerp(v2, t);}

}  // namespace tf2
