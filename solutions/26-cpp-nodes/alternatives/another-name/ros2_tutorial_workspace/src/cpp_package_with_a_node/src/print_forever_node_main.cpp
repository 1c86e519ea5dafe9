#include "print_forever_node.hpp"

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<printing::PrintForever>();
  auto timer = node->create_wall_timer(
    std::chrono::duration<double>(0.5), [node]() {node->tell();});
  while (rclcpp::ok()) {
    rclcpp::spin_some(node);
    rclcpp::sleep_for(std::chrono::milliseconds(5));
  }
  return 0;
}
