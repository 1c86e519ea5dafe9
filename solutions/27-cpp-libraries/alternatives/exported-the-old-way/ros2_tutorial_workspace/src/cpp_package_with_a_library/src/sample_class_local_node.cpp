#include "cpp_package_with_a_library/sample_class.hpp"

#include "rclcpp/rclcpp.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("sample_class_local_node");
  SampleClass sample;
  sample.set_a_private_member(7);
  auto timer = node->create_wall_timer(
    std::chrono::milliseconds(500), [&] {
      RCLCPP_INFO(
        node->get_logger(), "Sum of squares: %f, %s",
        SampleClass::sum_of_squares(2, 3), sample.to_string().c_str());
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
}
