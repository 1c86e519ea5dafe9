#pragma once

#include <ostream>
#include <string>

/// Stores a number, and computes a formula.
class SampleClass
{
public:
  int get_a_private_member() const;
  void set_a_private_member(int value);

  /// Returns `SampleClass(7)`, with the private member in the parentheses.
  std::string to_string() const;

  /// Returns a² + 2ab + b².
  static double sum_of_squares(double a, double b);

private:
  int a_private_member_ = 0;
};

/// Writes what `to_string` returns.
std::ostream & operator<<(std::ostream & stream, const SampleClass & sample);
