#include <rclcpp/rclcpp.hpp>

#include "print_forever_node.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);

  try {
    auto node = std::make_shared<PrintForeverNode>();
    rclcpp::spin(node);
  } catch (const std::exception & problem) {
    std::cerr << std::string("It ended with ") << problem.what();
  }

  return 0;
}
