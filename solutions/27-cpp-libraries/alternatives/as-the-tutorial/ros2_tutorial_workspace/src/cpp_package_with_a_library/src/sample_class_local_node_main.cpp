#include "sample_class_local_node.hpp"

// Like the tutorial's, it ends without rclcpp::shutdown.
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  try {
    rclcpp::spin(std::make_shared<SampleClassLocalNode>());
  } catch (const std::exception & problem) {
    std::cerr << "The node ended: " << problem.what();
  }
  return 0;
}
