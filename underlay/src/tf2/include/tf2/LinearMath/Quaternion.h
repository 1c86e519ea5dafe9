#pragma once

#include "tf2/LinearMath/Vector3.h"

namespace tf2
{

/// A rotation, as long as its length is one. It begins as zero, which is none.
class Quaternion
{
public:
  Quaternion() = default;
  Quaternion(const tf2Scalar & x, const tf2Scalar & y, const tf2Scalar & z, const tf2Scalar & w)
  : m_floats{x, y, z, w} {}
  Quaternion(const Vector3 & axis, const tf2Scalar & angle) {setRotation(axis, angle);}

  const tf2Scalar & x() const {return m_floats[0];}
  const tf2Scalar & y() const {return m_floats[1];}
  const tf2Scalar & z() const {return m_floats[2];}
  const tf2Scalar & w() const {return m_floats[3];}
  const tf2Scalar & getX() const {return m_floats[0];}
  const tf2Scalar & getY() const {return m_floats[1];}
  const tf2Scalar & getZ() const {return m_floats[2];}
  const tf2Scalar & getW() const {return m_floats[3];}
  void setX(tf2Scalar x) {m_floats[0] = x;}
  void setY(tf2Scalar y) {m_floats[1] = y;}
  void setZ(tf2Scalar z) {m_floats[2] = z;}
  void setW(tf2Scalar w) {m_floats[3] = w;}
  void setValue(const tf2Scalar & x, const tf2Scalar & y, const tf2Scalar & z) {*this = {x, y, z, 0};}
  void setValue(const tf2Scalar & x, const tf2Scalar & y, const tf2Scalar & z, const tf2Scalar & w)
  {
    *this = {x, y, z, w};
  }

  /// By index, too: q[3] is w.
  operator tf2Scalar *() {return m_floats;}
  operator const tf2Scalar *() const {return m_floats;}

  /// The axis may have any length but zero.
  void setRotation(const Vector3 & axis, const tf2Scalar & angle);
  /// Around the fixed axes x, y and z, in this order.
  void setRPY(const tf2Scalar & roll, const tf2Scalar & pitch, const tf2Scalar & yaw);
  /// Around y, x and z, each time as turned so far: setRPY is what robots use.
  void setEuler(const tf2Scalar & yaw, const tf2Scalar & pitch, const tf2Scalar & roll);

  Quaternion & operator+=(const Quaternion & q)
  {
    return *this = {x() + q.x(), y() + q.y(), z() + q.z(), w() + q.w()};
  }
  Quaternion & operator-=(const Quaternion & q)
  {
    return *this = {x() - q.x(), y() - q.y(), z() - q.z(), w() - q.w()};
  }
  Quaternion & operator*=(const tf2Scalar & s) {return *this = {x() * s, y() * s, z() * s, w() * s};}
  Quaternion & operator/=(const tf2Scalar & s) {return *this *= 1 / s;}
  /// The other one first, then this one.
  Quaternion & operator*=(const Quaternion & q);
  Quaternion operator+(const Quaternion & q) const {return Quaternion(*this) += q;}
  Quaternion operator-(const Quaternion & q) const {return Quaternion(*this) -= q;}
  Quaternion operator-() const {return {-x(), -y(), -z(), -w()};}
  Quaternion operator*(const tf2Scalar & s) const {return Quaternion(*this) *= s;}
  Quaternion operator/(const tf2Scalar & s) const {return Quaternion(*this) /= s;}
  bool operator==(const Quaternion & q) const
  {
    return x() == q.x() && y() == q.y() && z() == q.z() && w() == q.w();
  }
  bool operator!=(const Quaternion & q) const {return !(*this == q);}

  tf2Scalar dot(const Quaternion & q) const {return x() * q.x() + y() * q.y() + z() * q.z() + w() * q.w();}
  tf2Scalar length2() const {return dot(*this);}
  tf2Scalar length() const {return std::sqrt(length2());}
  Quaternion & normalize() {return *this /= length();}
  Quaternion normalized() const {return *this / length();}
  /// Of a quaternion of length one.
  Quaternion inverse() const {return {-x(), -y(), -z(), w()};}

  /// Half of the angle between the rotations.
  tf2Scalar angle(const Quaternion & q) const {return tf2Acos(dot(q) / std::sqrt(length2() * q.length2()));}
  tf2Scalar angleShortestPath(const Quaternion & q) const;
  tf2Scalar getAngle() const {return 2 * tf2Acos(w());}
  tf2Scalar getAngleShortestPath() const {return 2 * tf2Acos(std::fabs(w()));}
  Vector3 getAxis() const;

  /// Of `qd` and its negative, which is the same rotation.
  Quaternion farthest(const Quaternion & qd) const;
  Quaternion nearest(const Quaternion & qd) const;
  /// On the shortest path from this, where `t` is 0, to `q`, where it is 1.
  Quaternion slerp(const Quaternion & q, const tf2Scalar & t) const;

  static const Quaternion & getIdentity();

  tf2Scalar m_floats[4] = {};
};

inline Quaternion operator*(const Quaternion & q1, const Quaternion & q2) {return Quaternion(q1) *= q2;}
inline Quaternion operator*(const Quaternion & q, const Vector3 & v)
{
  return q * Quaternion(v.x(), v.y(), v.z(), 0);
}
inline Quaternion operator*(const Vector3 & v, const Quaternion & q)
{
  return Quaternion(v.x(), v.y(), v.z(), 0) * q;
}

inline tf2Scalar dot(const Quaternion & q1, const Quaternion & q2) {return q1.dot(q2);}
inline tf2Scalar length(const Quaternion & q) {return q.length();}
inline tf2Scalar angle(const Quaternion & q1, const Quaternion & q2) {return q1.angle(q2);}
inline tf2Scalar angleShortestPath(const Quaternion & q1, const Quaternion & q2)
{
  return q1.angleShortestPath(q2);
}
inline Quaternion inverse(const Quaternion & q) {return q.inverse();}
inline Quaternion slerp(const Quaternion & q1, const Quaternion & q2, const tf2Scalar & t)
{
  return q1.slerp(q2, t);
}

Vector3 quatRotate(const Quaternion & rotation, const Vector3 & v);
/// Turns `v0` into `v1`; both have length one.
Quaternion shortestArcQuat(const Vector3 & v0, const Vector3 & v1);
/// The same, for any lengths but zero; they become one.
Quaternion shortestArcQuatNormalize2(Vector3 & v0, Vector3 & v1);

}  // namespace tf2
