#include <memory>

#include <rclcpp/rclcpp.hpp>

#include "print_forever_node.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<PrintForeverNode>());
  rclcpp::shutdown();
  return 0;
}
