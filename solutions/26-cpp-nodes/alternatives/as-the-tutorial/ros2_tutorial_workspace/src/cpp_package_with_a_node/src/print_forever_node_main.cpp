#include "print_forever_node.hpp"

// Like the tutorial's, it ends without rclcpp::shutdown.
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  try {
    rclcpp::spin(std::make_shared<PrintForeverNode>());
  } catch (const std::exception & problem) {
    std::cerr << "It ended with " << problem.what();
  }
  return 0;
}
