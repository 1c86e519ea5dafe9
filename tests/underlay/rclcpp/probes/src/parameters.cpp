// A node with parameters of all kinds; logs their values at once, and each change.

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;

class Configured : public rclcpp::Node
{
public:
  Configured()
  : Node("configured")
  {
    rate_ = declare_parameter("rate", 2.5);
    declare_parameter("count", 3);
    declare_parameter<std::string>("name", "Ann");
    declare_parameter("numbers", std::vector<double>{1.0, 2.0});
    rcl_interfaces::msg::ParameterDescriptor limited;
    limited.description = "from nought to ten";
    limited.integer_range.resize(1);
    limited.integer_range[0].from_value = 0;
    limited.integer_range[0].to_value = 10;
    limited.integer_range[0].step = 2;
    declare_parameter("limited", 4, limited);
    rcl_interfaces::msg::ParameterDescriptor fixed;
    fixed.read_only = true;
    declare_parameter("fixed", true, fixed);
    judge_ = add_on_set_parameters_callback([this](const auto & given) {return judge(given);});
    told_ = add_post_set_parameters_callback([this](const auto & given) {show(given);});
    show(get_parameters({"rate", "count", "name", "numbers"}));
    timer_ = create_wall_timer(10ms, [this]() {follow_clock();});
  }

private:
  rcl_interfaces::msg::SetParametersResult judge(const std::vector<rclcpp::Parameter> & given)
  {
    rcl_interfaces::msg::SetParametersResult result;
    result.successful = true;
    for (const auto & parameter : given) {
      if (parameter.get_name() == "rate" && parameter.as_double() <= 0.0) {
        result.successful = false;
        result.reason = "a rate is positive";
      }
    }
    return result;
  }

  void show(const std::vector<rclcpp::Parameter> & given)
  {
    for (const auto & parameter : given) {
      const auto text = parameter.value_to_string();
      RCLCPP_INFO(get_logger(), "%s = %s", parameter.get_name().c_str(), text.c_str());
    }
  }

  void follow_clock()
  {
    if (get_clock()->ros_time_is_active() && now().seconds() > 0.0) {
      RCLCPP_INFO_ONCE(get_logger(), "simulated time: %.1f", now().seconds());
    }
  }

  double rate_;
  OnSetParametersCallbackHandle::SharedPtr judge_;
  PostSetParametersCallbackHandle::SharedPtr told_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  try {
    rclcpp::spin(std::make_shared<Configured>());
  } catch (const rclcpp::exceptions::InvalidParameterTypeException & error) {
    RCLCPP_FATAL(rclcpp::get_logger("main"), "%s", error.what());
    return 3;
  }
  rclcpp::shutdown();
  return 0;
}
