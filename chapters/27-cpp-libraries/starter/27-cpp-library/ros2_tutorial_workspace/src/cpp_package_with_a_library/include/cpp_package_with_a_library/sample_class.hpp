#pragma once

#include <ostream>
#include <string>

/// Keeps a number, and knows a formula.
class SampleClass
{
public:
  // TODO: declare get_a_private_member, set_a_private_member, to_string and sum_of_squares.

private:
  int a_private_member_ = 0;
};

// TODO: declare operator<<.
