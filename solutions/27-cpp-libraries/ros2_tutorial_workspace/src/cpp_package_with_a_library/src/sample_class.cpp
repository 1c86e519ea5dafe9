#include "cpp_package_with_a_library/sample_class.hpp"

#include <Eigen/Core>
#include <QString>

int SampleClass::get_a_private_member() const
{
  return a_private_member_;
}

void SampleClass::set_a_private_member(int value)
{
  a_private_member_ = value;
}

std::string SampleClass::to_string() const
{
  return QString("SampleClass(%1)").arg(a_private_member_).toStdString();
}

double SampleClass::sum_of_squares(double a, double b)
{
  const Eigen::Vector3d parts(a * a, 2.0 * a * b, b * b);
  return parts.sum();
}

std::ostream & operator<<(std::ostream & stream, const SampleClass & sample)
{
  return stream << sample.to_string();
}
