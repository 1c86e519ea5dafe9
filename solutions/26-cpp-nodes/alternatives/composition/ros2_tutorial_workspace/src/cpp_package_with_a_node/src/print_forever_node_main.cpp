#include <chrono>
#include <exception>
#include <iostream>
#include <memory>
#include <string>

#include <rclcpp/rclcpp.hpp>

class Counter
{
public:
  explicit Counter(rclcpp::Node & node)
  : logger_(node.get_logger()),
    timer_(node.create_timer(std::chrono::milliseconds(500), [this]() {count();}))
  {
  }

private:
  void count()
  {
    const std::string text = "Printed " + std::to_string(count_) + " times.";
    RCLCPP_INFO(logger_, "%s", text.c_str());
    ++count_;
  }

  rclcpp::Logger logger_;
  std::size_t count_{0};
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  try {
    rclcpp::init(argc, argv);
    const auto node = std::make_shared<rclcpp::Node>("print_forever");
    const Counter counter(*node);
    rclcpp::spin(node);
  } catch (const std::exception & error) {
    std::cerr << error.what() << std::endl;
    return 1;
  }
  rclcpp::shutdown();
  return 0;
}
