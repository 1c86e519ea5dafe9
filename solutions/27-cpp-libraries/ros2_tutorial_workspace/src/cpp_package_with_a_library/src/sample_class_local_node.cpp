#include <chrono>
#include <memory>

#include <rclcpp/rclcpp.hpp>

#include "cpp_package_with_a_library/sample_class.hpp"

using namespace std::chrono_literals;

/// Logs twice per second what the library returns.
class SampleClassLocalNode : public rclcpp::Node
{
public:
  SampleClassLocalNode()
  : rclcpp::Node("sample_class_local_node")
  {
    sample_.set_a_private_member(7);
    timer_ = create_wall_timer(500ms, [this]() {timer_callback_();});
  }

private:
  void timer_callback_()
  {
    RCLCPP_INFO_STREAM(get_logger(), "Sum of squares: " << SampleClass::sum_of_squares(2.0, 3.0));
    RCLCPP_INFO_STREAM(get_logger(), sample_);
  }

  SampleClass sample_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<SampleClassLocalNode>());
  rclcpp::shutdown();
  return 0;
}
