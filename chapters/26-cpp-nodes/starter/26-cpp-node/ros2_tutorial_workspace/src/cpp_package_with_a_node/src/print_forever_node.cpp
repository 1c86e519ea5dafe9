#include "print_forever_node.hpp"

PrintForeverNode::PrintForeverNode()
: rclcpp::Node("print_forever")
{
  // TODO: create the timer.
}

// TODO: the function that the timer calls.
