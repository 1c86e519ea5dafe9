#include <algorithm>

#include "tf2/LinearMath/Transform.h"
#include "tf2/utils.h"

namespace tf2
{

Vector3 Vector3::rotate(const Vector3 & wAxis, tf2Scalar angle) const
{
  return quatRotate(Quaternion(wAxis, angle), *this);
}

void Vector3::setInterpolate3(const Vector3 & v0, const Vector3 & v1, tf2Scalar rt)
{
  *this = v0 * (1 - rt) + v1 * rt;
}

Vector3 Vector3::lerp(const Vector3 & v, const tf2Scalar & t) const {return *this + (v - *this) * t;}

void Vector3::setMax(const Vector3 & other)
{
  for (int i = 0; i < 4; ++i) {
    m_floats[i] = std::max(m_floats[i], other.m_floats[i]);
  }
}

void Vector3::setMin(const Vector3 & other)
{
  for (int i = 0; i < 4; ++i) {
    m_floats[i] = std::min(m_floats[i], other.m_floats[i]);
  }
}

void Quaternion::setRotation(const Vector3 & axis, const tf2Scalar & angle)
{
  const Vector3 part = axis * (std::sin(angle / 2) / axis.length());
  *this = {part.x(), part.y(), part.z(), std::cos(angle / 2)};
}

namespace
{

struct HalfAngle
{
  explicit HalfAngle(tf2Scalar angle) : sine(std::sin(angle / 2)), cosine(std::cos(angle / 2)) {}
  const tf2Scalar sine, cosine;

  Quaternion around_x() const {return {sine, 0, 0, cosine};}
  Quaternion around_y() const {return {0, sine, 0, cosine};}
  Quaternion around_z() const {return {0, 0, sine, cosine};}
};

}  // namespace

void Quaternion::setRPY(const tf2Scalar & roll, const tf2Scalar & pitch, const tf2Scalar & yaw)
{
  *this = HalfAngle(yaw).around_z() * HalfAngle(pitch).around_y() * HalfAngle(roll).around_x();
}

void Quaternion::setEuler(const tf2Scalar & yaw, const tf2Scalar & pitch, const tf2Scalar & roll)
{
  *this = HalfAngle(yaw).around_y() * HalfAngle(pitch).around_x() * HalfAngle(roll).around_z();
}

Quaternion & Quaternion::operator*=(const Quaternion & q)
{
  const Vector3 mine(x(), y(), z()), other(q.x(), q.y(), q.z());
  const Vector3 part = other * w() + mine * q.w() + mine.cross(other);
  return *this = {part.x(), part.y(), part.z(), w() * q.w() - mine.dot(other)};
}

tf2Scalar Quaternion::angleShortestPath(const Quaternion & q) const
{
  return 2 * tf2Acos(std::fabs(dot(q)) / std::sqrt(length2() * q.length2()));
}

Vector3 Quaternion::getAxis() const
{
  const tf2Scalar squared = 1 - w() * w();
  if (squared < 10 * TF2SIMD_EPSILON) {
    return {1, 0, 0};  // any axis: there is no rotation
  }
  return Vector3(x(), y(), z()) / std::sqrt(squared);
}

Quaternion Quaternion::farthest(const Quaternion & qd) const {return dot(qd) < 0 ? qd : -qd;}

Quaternion Quaternion::nearest(const Quaternion & qd) const {return dot(qd) < 0 ? -qd : qd;}

Quaternion Quaternion::slerp(const Quaternion & q, const tf2Scalar & t) const
{
  const tf2Scalar theta = angleShortestPath(q) / 2;
  if (theta == 0) {
    return *this;
  }
  return (*this * std::sin((1 - t) * theta) + nearest(q) * std::sin(t * theta)) / std::sin(theta);
}

const Quaternion & Quaternion::getIdentity()
{
  static const Quaternion identity(0, 0, 0, 1);
  return identity;
}

Vector3 quatRotate(const Quaternion & rotation, const Vector3 & v)
{
  const Quaternion turned = rotation * v * rotation.inverse();
  return {turned.x(), turned.y(), turned.z()};
}

Quaternion shortestArcQuat(const Vector3 & v0, const Vector3 & v1)
{
  const tf2Scalar cosine = v0.dot(v1);
  if (cosine < -1 + TF2SIMD_EPSILON) {
    // They are opposite: around any axis that is upright on both.
    const Vector3 other = std::fabs(v0.z()) < 0.7 ? Vector3(0, 0, 1) : Vector3(1, 0, 0);
    return Quaternion(v0.cross(other), TF2SIMD_PI);
  }
  const Vector3 axis = v0.cross(v1);
  return Quaternion(axis.x(), axis.y(), axis.z(), 1 + cosine).normalize();
}

Quaternion shortestArcQuatNormalize2(Vector3 & v0, Vector3 & v1)
{
  return shortestArcQuat(v0.normalize(), v1.normalize());
}

const Matrix3x3 & Matrix3x3::getIdentity()
{
  static const Matrix3x3 identity(1, 0, 0, 0, 1, 0, 0, 0, 1);
  return identity;
}

void Matrix3x3::setRotation(const Quaternion & q)
{
  // The length of q need not be one.
  const tf2Scalar twice = 2 / q.length2();
  const Vector3 v(q.x(), q.y(), q.z()), turned = v * (twice * q.w());
  const Vector3 by_x = v * (twice * v.x()), by_y = v * (twice * v.y()), by_z = v * (twice * v.z());
  *this = {
    1 - (by_y.y() + by_z.z()), by_x.y() - turned.z(), by_x.z() + turned.y(),
    by_x.y() + turned.z(), 1 - (by_x.x() + by_z.z()), by_y.z() - turned.x(),
    by_x.z() - turned.y(), by_y.z() + turned.x(), 1 - (by_x.x() + by_y.y())};
}

void Matrix3x3::getRotation(Quaternion & q) const
{
  const Vector3 diagonal(m_el[0].x(), m_el[1].y(), m_el[2].z());
  const tf2Scalar trace = diagonal.x() + diagonal.y() + diagonal.z();
  // What is divided by is the largest part, so little is lost.
  if (trace > 0) {
    const tf2Scalar s = std::sqrt(trace + 1), half = 0.5 / s;
    q = {
      (m_el[2][1] - m_el[1][2]) * half, (m_el[0][2] - m_el[2][0]) * half,
      (m_el[1][0] - m_el[0][1]) * half, s / 2};
    return;
  }
  const int i = diagonal.maxAxis(), j = (i + 1) % 3, k = (i + 2) % 3;
  const tf2Scalar s = std::sqrt(diagonal[i] - diagonal[j] - diagonal[k] + 1), half = 0.5 / s;
  q.m_floats[i] = s / 2;
  q.m_floats[j] = (m_el[j][i] + m_el[i][j]) * half;
  q.m_floats[k] = (m_el[k][i] + m_el[i][k]) * half;
  q.m_floats[3] = (m_el[k][j] - m_el[j][k]) * half;
}

void Matrix3x3::setRPY(tf2Scalar roll, tf2Scalar pitch, tf2Scalar yaw)
{
  Quaternion q;
  q.setRPY(roll, pitch, yaw);
  setRotation(q);
}

void Matrix3x3::getRPY(
  tf2Scalar & roll, tf2Scalar & pitch, tf2Scalar & yaw, unsigned int solution_number) const
{
  const tf2Scalar sine = -m_el[2][0];
  if (std::fabs(sine) >= 1) {  // upright: roll and yaw turn around the same axis
    roll = std::atan2(std::copysign(1, sine) * m_el[0][1], std::copysign(1, sine) * m_el[0][2]);
    pitch = std::copysign(TF2SIMD_HALF_PI, sine);
    yaw = 0;
    return;
  }
  const tf2Scalar sign = solution_number == 1 ? 1 : -1;
  pitch = solution_number == 1 ? std::asin(sine) : TF2SIMD_PI - std::asin(sine);
  roll = std::atan2(sign * m_el[2][1], sign * m_el[2][2]);
  yaw = std::atan2(sign * m_el[1][0], sign * m_el[0][0]);
}

Matrix3x3 & Matrix3x3::operator*=(const Matrix3x3 & m)
{
  for (auto & row : m_el) {
    row = {m.tdotx(row), m.tdoty(row), m.tdotz(row)};
  }
  return *this;
}

Matrix3x3 Matrix3x3::transpose() const
{
  Matrix3x3 result;
  for (int i = 0; i < 3; ++i) {
    result[i] = getColumn(i);
  }
  return result;
}

Matrix3x3 Matrix3x3::adjoint() const
{
  Matrix3x3 cofactors;
  for (int i = 0; i < 3; ++i) {
    cofactors[i] = m_el[(i + 1) % 3].cross(m_el[(i + 2) % 3]);
  }
  return cofactors.transpose();
}

Matrix3x3 Matrix3x3::inverse() const
{
  const tf2Scalar factor = 1 / determinant();
  return adjoint().scaled({factor, factor, factor});
}

Matrix3x3 Matrix3x3::absolute() const
{
  Matrix3x3 result;
  for (int i = 0; i < 3; ++i) {
    result[i] = m_el[i].absolute();
  }
  return result;
}

Matrix3x3 Matrix3x3::scaled(const Vector3 & s) const
{
  Matrix3x3 result;
  for (int i = 0; i < 3; ++i) {
    result[i] = m_el[i] * s;
  }
  return result;
}

Quaternion Transform::getRotation() const
{
  Quaternion q;
  m_basis.getRotation(q);
  return q;
}

const Transform & Transform::getIdentity()
{
  static const Transform identity(Matrix3x3::getIdentity());
  return identity;
}

Transform Transform::inverse() const
{
  const Matrix3x3 back = m_basis.transpose();
  return Transform(back, back * -m_origin);
}

void impl::getEulerYPR(const Quaternion & q, double & yaw, double & pitch, double & roll)
{
  const double xx = q.x() * q.x(), yy = q.y() * q.y(), zz = q.z() * q.z(), ww = q.w() * q.w();
  const double sine = 2 * (q.w() * q.y() - q.x() * q.z()) / (xx + yy + zz + ww);
  if (std::fabs(sine) >= 0.99999) {  // upright: roll and yaw turn around the same axis
    pitch = std::copysign(TF2SIMD_HALF_PI, sine);
    roll = 0;
    yaw = std::copysign(2, -sine) * std::atan2(q.x(), std::copysign(1, sine) * q.y());
    return;
  }
  pitch = std::asin(sine);
  roll = std::atan2(2 * (q.y() * q.z() + q.w() * q.x()), ww - xx - yy + zz);
  yaw = std::atan2(2 * (q.x() * q.y() + q.w() * q.z()), ww + xx - yy - zz);
}

}  // namespace tf2
