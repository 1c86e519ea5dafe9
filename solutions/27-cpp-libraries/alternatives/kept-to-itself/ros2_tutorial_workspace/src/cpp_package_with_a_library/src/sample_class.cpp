#include "cpp_package_with_a_library/sample_class.hpp"

#include <ostream>

#include <Eigen/Dense>
#include <QtCore/QString>

struct SampleClass::Inside
{
  int a_private_member = 0;
};

SampleClass::SampleClass()
: inside_(std::make_unique<Inside>())
{
}

SampleClass::~SampleClass() = default;

const int & SampleClass::get_a_private_member() const noexcept
{
  return inside_->a_private_member;
}

void SampleClass::set_a_private_member(const int & value) noexcept
{
  inside_->a_private_member = value;
}

std::string SampleClass::to_string() const
{
  return QString("SampleClass(" + QString::number(get_a_private_member()) + ")").toStdString();
}

double SampleClass::sum_of_squares(const double & a, const double & b) noexcept
{
  return (Eigen::Vector2d(a, b) * Eigen::RowVector2d(a, b)).sum();
}

std::ostream & operator<<(std::ostream & stream, const SampleClass & sample)
{
  stream << sample.to_string();
  return stream;
}
