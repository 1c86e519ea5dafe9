#pragma once

#include "tf2/LinearMath/Quaternion.h"
#include "tf2/LinearMath/Vector3.h"

namespace tf2
{

/// Three rows, most often of a rotation. It begins as zero.
class Matrix3x3
{
public:
  Matrix3x3() = default;
  explicit Matrix3x3(const Quaternion & q) {setRotation(q);}
  Matrix3x3(
    const tf2Scalar & xx, const tf2Scalar & xy, const tf2Scalar & xz,
    const tf2Scalar & yx, const tf2Scalar & yy, const tf2Scalar & yz,
    const tf2Scalar & zx, const tf2Scalar & zy, const tf2Scalar & zz)
  : m_el{{xx, xy, xz}, {yx, yy, yz}, {zx, zy, zz}} {}

  Vector3 getColumn(int i) const {return {m_el[0][i], m_el[1][i], m_el[2][i]};}
  const Vector3 & getRow(int i) const {return m_el[i];}
  Vector3 & operator[](int i) {return m_el[i];}
  const Vector3 & operator[](int i) const {return m_el[i];}

  void setValue(
    const tf2Scalar & xx, const tf2Scalar & xy, const tf2Scalar & xz,
    const tf2Scalar & yx, const tf2Scalar & yy, const tf2Scalar & yz,
    const tf2Scalar & zx, const tf2Scalar & zy, const tf2Scalar & zz)
  {
    *this = {xx, xy, xz, yx, yy, yz, zx, zy, zz};
  }
  void setIdentity() {*this = getIdentity();}
  static const Matrix3x3 & getIdentity();

  /// Of a quaternion of any length but zero.
  void setRotation(const Quaternion & q);
  void getRotation(Quaternion & q) const;

  // Around the fixed axes x, y and z, in this order. There are two solutions, number 1 and number 2.
  void setRPY(tf2Scalar roll, tf2Scalar pitch, tf2Scalar yaw);
  void getRPY(
    tf2Scalar & roll, tf2Scalar & pitch, tf2Scalar & yaw, unsigned int solution_number = 1) const;
  void setEulerYPR(tf2Scalar eulerZ, tf2Scalar eulerY, tf2Scalar eulerX) {setRPY(eulerX, eulerY, eulerZ);}
  void getEulerYPR(
    tf2Scalar & yaw, tf2Scalar & pitch, tf2Scalar & roll, unsigned int solution_number = 1) const
  {
    getRPY(roll, pitch, yaw, solution_number);
  }

  Matrix3x3 & operator*=(const Matrix3x3 & m);
  tf2Scalar determinant() const {return m_el[0].triple(m_el[1], m_el[2]);}
  Matrix3x3 transpose() const;
  Matrix3x3 adjoint() const;
  Matrix3x3 inverse() const;
  Matrix3x3 absolute() const;
  Matrix3x3 scaled(const Vector3 & s) const;
  Matrix3x3 transposeTimes(const Matrix3x3 & m) const {return transpose() *= m;}
  Matrix3x3 timesTranspose(const Matrix3x3 & m) const {return Matrix3x3(*this) *= m.transpose();}
  tf2Scalar tdotx(const Vector3 & v) const {return getColumn(0).dot(v);}
  tf2Scalar tdoty(const Vector3 & v) const {return getColumn(1).dot(v);}
  tf2Scalar tdotz(const Vector3 & v) const {return getColumn(2).dot(v);}

private:
  Vector3 m_el[3];
};

inline Matrix3x3 operator*(const Matrix3x3 & m1, const Matrix3x3 & m2) {return Matrix3x3(m1) *= m2;}
inline Vector3 operator*(const Matrix3x3 & m, const Vector3 & v)
{
  return {m[0].dot(v), m[1].dot(v), m[2].dot(v)};
}
inline Vector3 operator*(const Vector3 & v, const Matrix3x3 & m)
{
  return {m.tdotx(v), m.tdoty(v), m.tdotz(v)};
}
inline bool operator==(const Matrix3x3 & m1, const Matrix3x3 & m2)
{
  return m1[0] == m2[0] && m1[1] == m2[1] && m1[2] == m2[2];
}

}  // namespace tf2
