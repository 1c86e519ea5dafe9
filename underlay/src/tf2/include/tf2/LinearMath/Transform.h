#pragma once

#include "tf2/LinearMath/Matrix3x3.h"
#include "tf2/LinearMath/Quaternion.h"
#include "tf2/LinearMath/Vector3.h"

namespace tf2
{

/// A rotation, then a translation. Without either it begins as zero, which is not the identity.
class Transform
{
public:
  Transform() = default;
  explicit Transform(const Quaternion & q, const Vector3 & c = {}) : m_basis(q), m_origin(c) {}
  explicit Transform(const Matrix3x3 & b, const Vector3 & c = {}) : m_basis(b), m_origin(c) {}

  Matrix3x3 & getBasis() {return m_basis;}
  const Matrix3x3 & getBasis() const {return m_basis;}
  Vector3 & getOrigin() {return m_origin;}
  const Vector3 & getOrigin() const {return m_origin;}
  Quaternion getRotation() const;
  void setBasis(const Matrix3x3 & basis) {m_basis = basis;}
  void setOrigin(const Vector3 & origin) {m_origin = origin;}
  void setRotation(const Quaternion & q) {m_basis.setRotation(q);}
  void setIdentity() {*this = getIdentity();}
  static const Transform & getIdentity();

  Vector3 operator()(const Vector3 & x) const {return m_basis * x + m_origin;}
  Vector3 operator*(const Vector3 & x) const {return (*this)(x);}
  Quaternion operator*(const Quaternion & q) const {return getRotation() * q;}
  Transform operator*(const Transform & t) const {return Transform(m_basis * t.m_basis, (*this)(t.m_origin));}
  Transform & operator*=(const Transform & t) {return *this = *this * t;}
  void mult(const Transform & t1, const Transform & t2) {*this = t1 * t2;}

  Transform inverse() const;
  Transform inverseTimes(const Transform & t) const {return inverse() * t;}
  Vector3 invXform(const Vector3 & inVec) const {return m_basis.transpose() * (inVec - m_origin);}

private:
  Matrix3x3 m_basis;
  Vector3 m_origin;
};

inline bool operator==(const Transform & t1, const Transform & t2)
{
  return t1.getBasis() == t2.getBasis() && t1.getOrigin() == t2.getOrigin();
}

}  // namespace tf2
