// Dual quaternions: q(0) + q(1)*i_ + q(2)*j_ + q(3)*k_ + E_*(q(4) + q(5)*i_ + q(6)*j_ + q(7)*k_).

#pragma once

#include <ostream>
#include <string>
#include <type_traits>

#include <Eigen/Dense>

namespace DQ_robotics
{

/// Two numbers are equal when they differ by no more than this.
constexpr double DQ_threshold = 1e-12;

/// A unit one, r + 0.5*E_*t*r, is a pose: r is its rotation and t its translation.
class DQ
{
public:
  using Matrix8 = Eigen::Matrix<double, 8, 8>;

  Eigen::Matrix<double, 8, 1> q;

  static const DQ i, j, k, E;

  /// Of 8 elements all; of 6 the imaginary ones; of 4 those of a quaternion, of 3 its imaginary ones; of 1 a
  /// number. Throws std::range_error for another size.
  explicit DQ(const Eigen::VectorXd & v);
  explicit DQ(
    const double & q0 = 0.0, const double & q1 = 0.0, const double & q2 = 0.0, const double & q3 = 0.0,
    const double & q4 = 0.0, const double & q5 = 0.0, const double & q6 = 0.0,
    const double & q7 = 0.0) noexcept;

  DQ P() const;   ///< the part without E_
  DQ D() const;   ///< the part that E_ multiplies
  DQ Re() const;  ///< the elements that no i_, j_ or k_ multiplies
  DQ Im() const;
  DQ conj() const;
  DQ sharp() const;  ///< the part with E_ negated
  DQ norm() const;
  DQ inv() const;
  DQ normalize() const;

  /// Of a pose. Throw std::range_error for anything but a unit dual quaternion.
  DQ translation() const;
  DQ rotation() const;
  DQ rotation_axis() const;       ///< k_ where nothing is turned
  double rotation_angle() const;  ///< from 0 to 2*pi
  DQ log() const;
  DQ pow(const double a) const;

  /// Throws std::range_error when there is a real part.
  DQ exp() const;

  DQ Ad(const DQ & other) const;  ///< this * other * conj(this)

  /// a.hamiplus8() * vec8(b) == b.haminus8() * vec8(a) == vec8(a * b); the smaller ones are for quaternions.
  Eigen::Matrix4d hamiplus4() const;
  Eigen::Matrix4d haminus4() const;
  Matrix8 hamiplus8() const;
  Matrix8 haminus8() const;

  Eigen::Vector3d vec3() const;
  Eigen::Vector4d vec4() const;
  Eigen::Matrix<double, 6, 1> vec6() const;
  Eigen::Matrix<double, 8, 1> vec8() const {return q;}

  /// For example "1 + 2i + E*( - 3k)"; 0 where nothing else is.
  std::string to_string() const;

  DQ operator-() const {return DQ(-q);}
  bool operator==(const DQ & other) const;
  bool operator!=(const DQ & other) const {return !(*this == other);}
  explicit operator double() const {return q(0);}
  explicit operator int() const {return static_cast<int>(q(0));}

  template<typename Scalar, typename = std::enable_if_t<std::is_arithmetic_v<Scalar>>>
  DQ & operator=(const Scalar & scalar) {return *this = DQ(static_cast<double>(scalar));}
};

inline const DQ E_(0.0, 0.0, 0.0, 0.0, 1.0);
inline const DQ i_(0.0, 1.0);
inline const DQ j_(0.0, 0.0, 1.0);
inline const DQ k_(0.0, 0.0, 0.0, 1.0);

DQ operator+(const DQ & a, const DQ & b) noexcept;
DQ operator-(const DQ & a, const DQ & b) noexcept;
DQ operator*(const DQ & a, const DQ & b) noexcept;
std::ostream & operator<<(std::ostream & stream, const DQ & dq);

// A number stands for the dual quaternion that has it in q(0), and nothing else.
template<typename Scalar>
using DQOfNumber =
  std::enable_if_t<std::is_arithmetic_v<Scalar> && !std::is_same_v<Scalar, bool>, DQ>;
template<typename Scalar>
DQOfNumber<Scalar> operator+(const DQ & dq, const Scalar & s) noexcept {return dq + DQ(s);}
template<typename Scalar>
DQOfNumber<Scalar> operator+(const Scalar & s, const DQ & dq) noexcept {return DQ(s) + dq;}
template<typename Scalar>
DQOfNumber<Scalar> operator-(const DQ & dq, const Scalar & s) noexcept {return dq - DQ(s);}
template<typename Scalar>
DQOfNumber<Scalar> operator-(const Scalar & s, const DQ & dq) noexcept {return DQ(s) - dq;}
template<typename Scalar>
DQOfNumber<Scalar> operator*(const DQ & dq, const Scalar & s) noexcept {return DQ(s * dq.q);}
template<typename Scalar>
DQOfNumber<Scalar> operator*(const Scalar & s, const DQ & dq) noexcept {return DQ(s * dq.q);}
template<typename Scalar, typename = DQOfNumber<Scalar>>
bool operator==(const DQ & dq, const Scalar & s) noexcept {return dq == DQ(s);}
template<typename Scalar, typename = DQOfNumber<Scalar>>
bool operator==(const Scalar & s, const DQ & dq) noexcept {return dq == DQ(s);}
template<typename Scalar, typename = DQOfNumber<Scalar>>
bool operator!=(const DQ & dq, const Scalar & s) noexcept {return dq != DQ(s);}
template<typename Scalar, typename = DQOfNumber<Scalar>>
bool operator!=(const Scalar & s, const DQ & dq) noexcept {return dq != DQ(s);}

inline DQ P(const DQ & dq) {return dq.P();}
inline DQ D(const DQ & dq) {return dq.D();}
inline DQ Re(const DQ & dq) {return dq.Re();}
inline DQ Im(const DQ & dq) {return dq.Im();}
inline DQ conj(const DQ & dq) {return dq.conj();}
inline DQ sharp(const DQ & dq) {return dq.sharp();}
inline DQ norm(const DQ & dq) {return dq.norm();}
inline DQ inv(const DQ & dq) {return dq.inv();}
inline DQ normalize(const DQ & dq) {return dq.normalize();}
inline DQ translation(const DQ & dq) {return dq.translation();}
inline DQ rotation(const DQ & dq) {return dq.rotation();}
inline DQ rotation_axis(const DQ & dq) {return dq.rotation_axis();}
inline double rotation_angle(const DQ & dq) {return dq.rotation_angle();}
inline DQ log(const DQ & dq) {return dq.log();}
inline DQ exp(const DQ & dq) {return dq.exp();}
inline DQ pow(const DQ & dq, const double & a) {return dq.pow(a);}
inline DQ Ad(const DQ & a, const DQ & b) {return a.Ad(b);}
inline Eigen::Matrix4d hamiplus4(const DQ & dq) {return dq.hamiplus4();}
inline Eigen::Matrix4d haminus4(const DQ & dq) {return dq.haminus4();}
inline DQ::Matrix8 hamiplus8(const DQ & dq) {return dq.hamiplus8();}
inline DQ::Matrix8 haminus8(const DQ & dq) {return dq.haminus8();}
inline Eigen::Vector3d vec3(const DQ & dq) {return dq.vec3();}
inline Eigen::Vector4d vec4(const DQ & dq) {return dq.vec4();}
inline Eigen::Matrix<double, 6, 1> vec6(const DQ & dq) {return dq.vec6();}
inline Eigen::Matrix<double, 8, 1> vec8(const DQ & dq) {return dq.vec8();}

/// Of vectors, as in geometry: imaginary quaternions.
DQ dot(const DQ & a, const DQ & b);
DQ cross(const DQ & a, const DQ & b);

inline bool is_unit(const DQ & dq) {return dq.norm() == 1.0;}
inline bool is_pure(const DQ & dq) {return dq.Re() == 0.0;}
inline bool is_real(const DQ & dq) {return dq.Im() == 0.0;}
inline bool is_real_number(const DQ & dq) {return is_real(dq) && dq.D() == 0.0;}
inline bool is_quaternion(const DQ & dq) {return dq.D() == 0.0;}
inline bool is_pure_quaternion(const DQ & dq) {return is_pure(dq) && is_quaternion(dq);}

/// vec4(conj(a)) == C4() * vec4(a), and the same of 8.
Eigen::Matrix4d C4();
DQ::Matrix8 C8();

}  // namespace DQ_robotics

using namespace Eigen;  // NOLINT: programs of this family write VectorXd without a namespace
