#include "print_forever_node.hpp"

namespace printing
{

PrintForever::PrintForever(const rclcpp::NodeOptions & options)
: Node("cpp_print_forever_node", options)
{
}

void PrintForever::tell()
{
  RCLCPP_INFO_STREAM(get_logger(), "Printed " << told_++ << " times.");
}

}  // namespace printing
