#pragma once

#include <ostream>
#include <string>

/// Keeps a number, and knows a formula.
class SampleClass
{
public:
  int get_a_private_member() const;
  void set_a_private_member(int value);

  /// `SampleClass(7)`, with the private member in the brackets.
  std::string to_string() const;

  /// a² + 2ab + b².
  static double sum_of_squares(double a, double b);

private:
  int a_private_member_ = 0;
};

/// Writes what `to_string` returns.
std::ostream & operator<<(std::ostream & stream, const SampleClass & sample);
