#include <rclcpp/rclcpp.hpp>

#include "cpp_package_with_a_library/sample_class.hpp"

// TODO: a node as in the chapter before, with an object of SampleClass as a member.

int main(int argc, char ** argv)
{
  // TODO: init, spin, shutdown.
  return 0;
}
