#include <dqrobotics/DQ.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace DQ_robotics
{

namespace
{

using Quaternion = Eigen::Vector4d;

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d & v)
{
  Eigen::Matrix3d matrix;
  matrix << 0.0, -v(2), v(1), v(2), 0.0, -v(0), -v(1), v(0), 0.0;
  return matrix;
}

/// The matrix that multiplies by `quaternion`: with sign 1 from the left, with -1 from the right.
Eigen::Matrix4d multiplication(const Quaternion & quaternion, double sign)
{
  const Eigen::Vector3d v = quaternion.tail<3>();
  Eigen::Matrix4d matrix = quaternion(0) * Eigen::Matrix4d::Identity();
  matrix.topRightCorner<1, 3>() = -v.transpose();
  matrix.bottomLeftCorner<3, 1>() = v;
  matrix.bottomRightCorner<3, 3>() += sign * cross_matrix(v);
  return matrix;
}

DQ::Matrix8 multiplication_of_dual(const DQ & dq, double sign)
{
  DQ::Matrix8 matrix = DQ::Matrix8::Zero();
  matrix.topLeftCorner<4, 4>() = multiplication(dq.q.head<4>(), sign);
  matrix.bottomRightCorner<4, 4>() = matrix.topLeftCorner<4, 4>();
  matrix.bottomLeftCorner<4, 4>() = multiplication(dq.q.tail<4>(), sign);
  return matrix;
}

DQ dual(const Quaternion & primary, const Quaternion & dual)
{
  DQ result;
  result.q << primary, dual;
  return result;
}

void needs_unit(const DQ & dq, const std::string & function)
{
  if (!is_unit(dq)) {
    throw std::range_error(
      "DQ::" + function + " needs a unit dual quaternion; the norm of this one is " +
      dq.norm().to_string() + ".");
  }
}

/// Six digits after the point at most.
std::string text_of(double number)
{
  std::string text = std::to_string(number);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text;
}

std::string text_of(const Quaternion & quaternion)
{
  constexpr std::array units{"", "i", "j", "k"};
  std::string text;
  for (int n = 0; n < 4; ++n) {
    const double element = quaternion(n);
    if (std::abs(element) > DQ_threshold) {
      text += element < 0.0 ? " - " : text.empty() ? "" : " + ";
      text += text_of(std::abs(element)) + units[n];
    }
  }
  return text;
}

}  // namespace

const DQ DQ::i(0.0, 1.0);
const DQ DQ::j(0.0, 0.0, 1.0);
const DQ DQ::k(0.0, 0.0, 0.0, 1.0);
const DQ DQ::E(0.0, 0.0, 0.0, 0.0, 1.0);

DQ::DQ(
  const double & q0, const double & q1, const double & q2, const double & q3, const double & q4,
  const double & q5, const double & q6, const double & q7) noexcept
{
  q << q0, q1, q2, q3, q4, q5, q6, q7;
}

DQ::DQ(const Eigen::VectorXd & v)
: q(Eigen::Matrix<double, 8, 1>::Zero())
{
  switch (v.size()) {
    case 8:
    case 4:
    case 1:
      q.head(v.size()) = v;
      break;
    case 6:
      q.tail<3>() = v.tail<3>();
      [[fallthrough]];
    case 3:
      q.segment<3>(1) = v.head<3>();
      break;
    default:
      throw std::range_error(
        "A DQ is made of 1, 3, 4, 6 or 8 elements, not of " + std::to_string(v.size()) + ".");
  }
}

DQ DQ::P() const {return dual(q.head<4>(), Quaternion::Zero());}
DQ DQ::D() const {return dual(q.tail<4>(), Quaternion::Zero());}
DQ DQ::Re() const {return DQ(q(0), 0.0, 0.0, 0.0, q(4));}
DQ DQ::Im() const {return DQ(vec6());}
DQ DQ::conj() const {return DQ(C8() * q);}
DQ DQ::sharp() const {return dual(q.head<4>(), -q.tail<4>());}

DQ DQ::norm() const
{
  if (P() == 0.0) {
    return DQ(0.0);
  }
  const DQ square = conj() * *this;  // a + b*E_, whose root is sqrt(a) + b/(2*sqrt(a))*E_
  const double root = std::sqrt(square.q(0));
  const double slope = square.q(4) / (2.0 * root);
  return DQ(root, 0.0, 0.0, 0.0, std::abs(slope) < DQ_threshold ? 0.0 : slope);
}

DQ DQ::inv() const
{
  const DQ square = *this * conj();
  return conj() *
         DQ(1.0 / square.q(0), 0.0, 0.0, 0.0, -square.q(4) / (square.q(0) * square.q(0)));
}

DQ DQ::normalize() const {return *this * norm().inv();}

DQ DQ::translation() const
{
  needs_unit(*this, "translation");
  return 2.0 * D() * P().conj();
}

DQ DQ::rotation() const
{
  needs_unit(*this, "rotation");
  return P();
}

DQ DQ::rotation_axis() const
{
  const double half = rotation_angle() / 2.0;
  return half == 0.0 ? k_ : P().Im() * (1.0 / std::sin(half));
}

double DQ::rotation_angle() const
{
  needs_unit(*this, "rotation_angle");
  return 2.0 * std::acos(std::clamp(q(0), -1.0, 1.0));
}

DQ DQ::log() const
{
  return 0.5 * rotation_angle() * rotation_axis() + E_ * (0.5 * translation());
}

DQ DQ::exp() const
{
  if (!is_pure(*this)) {
    throw std::range_error("DQ::exp needs a dual quaternion without a real part; this is " + to_string() + ".");
  }
  const double angle = q.head<4>().norm();
  const DQ primary = angle == 0.0 ? DQ(1.0) : std::cos(angle) + (std::sin(angle) / angle) * P();
  return primary + E_ * D() * primary;
}

DQ DQ::pow(const double a) const {return (a * log()).exp();}
DQ DQ::Ad(const DQ & other) const {return *this * other * conj();}

Eigen::Matrix4d DQ::hamiplus4() const {return multiplication(q.head<4>(), 1.0);}
Eigen::Matrix4d DQ::haminus4() const {return multiplication(q.head<4>(), -1.0);}
DQ::Matrix8 DQ::hamiplus8() const {return multiplication_of_dual(*this, 1.0);}
DQ::Matrix8 DQ::haminus8() const {return multiplication_of_dual(*this, -1.0);}

Eigen::Vector3d DQ::vec3() const {return q.segment<3>(1);}
Eigen::Vector4d DQ::vec4() const {return q.head<4>();}

Eigen::Matrix<double, 6, 1> DQ::vec6() const
{
  Eigen::Matrix<double, 6, 1> vector;
  vector << q.segment<3>(1), q.tail<3>();
  return vector;
}

std::string DQ::to_string() const
{
  const std::string primary = text_of(Quaternion(q.head<4>()));
  const std::string dual = text_of(Quaternion(q.tail<4>()));
  if (dual.empty()) {
    return primary.empty() ? "0" : primary;
  }
  return primary + (primary.empty() ? "" : " + ") + "E*(" + dual + ")";
}

bool DQ::operator==(const DQ & other) const
{
  return ((q - other.q).array().abs() <= DQ_threshold).all();
}

DQ operator+(const DQ & a, const DQ & b) noexcept {return DQ(a.q + b.q);}
DQ operator-(const DQ & a, const DQ & b) noexcept {return DQ(a.q - b.q);}
DQ operator*(const DQ & a, const DQ & b) noexcept {return DQ(a.hamiplus8() * b.q);}
std::ostream & operator<<(std::ostream & stream, const DQ & dq) {return stream << dq.to_string();}

DQ dot(const DQ & a, const DQ & b) {return -0.5 * (a * b + b * a);}
DQ cross(const DQ & a, const DQ & b) {return 0.5 * (a * b - b * a);}

Eigen::Matrix4d C4()
{
  return Eigen::Vector4d(1.0, -1.0, -1.0, -1.0).asDiagonal();
}

DQ::Matrix8 C8()
{
  DQ::Matrix8 matrix = DQ::Matrix8::Zero();
  matrix.topLeftCorner<4, 4>() = matrix.bottomRightCorner<4, 4>() = C4();
  return matrix;
}

}  // namespace DQ_robotics
