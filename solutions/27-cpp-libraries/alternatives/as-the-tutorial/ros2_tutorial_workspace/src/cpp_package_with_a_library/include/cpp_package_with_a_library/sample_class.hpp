#pragma once

#include <ostream>
#include <string>

#include <QString>
#include <eigen3/Eigen/Dense>

/// A number that others can set, a text and a matrix that stay as they are.
class SampleClass
{
public:
  SampleClass();

  static double sum_of_squares(const double & a, const double & b);

  std::string to_string() const;
  void set_a_private_member(int number);
  int get_a_private_member() const;

private:
  int number_;  // without a starting value, as in the tutorial
  const QString text_;
  const Eigen::MatrixXd matrix_;
};

std::ostream & operator<<(std::ostream & stream, const SampleClass & sample);
