#include <cpp_package_with_a_library/sample_class.hpp>

#include <sstream>

SampleClass::SampleClass()
: text_("a text of Qt"), matrix_(Eigen::Matrix2d::Identity())
{
}

double SampleClass::sum_of_squares(const double & a, const double & b)
{
  return a * a + 2 * a * b + b * b;
}

std::string SampleClass::to_string() const
{
  std::stringstream lines;
  lines << "Sample_Class:: " << std::endl;
  lines << "a_private_member_ = " << number_ << std::endl;
  lines << "a_text = " << text_.toStdString() << std::endl;
  lines << "a_matrix = " << matrix_ << std::endl;
  return lines.str();
}

void SampleClass::set_a_private_member(int number)
{
  number_ = number;
}

int SampleClass::get_a_private_member() const
{
  return number_;
}

std::ostream & operator<<(std::ostream & stream, const SampleClass & sample)
{
  return stream << sample.to_string();
}
