#include <memory>

#include <rclcpp/rclcpp.hpp>

#include "print_forever_node.hpp"

int main(int argc, char ** argv)
{
  // TODO: init, spin, shutdown.
  return 0;
}
