#include "time_source.hpp"

#include <stdexcept>
#include <utility>

#include "rclcpp/detail/check.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/subscription.hpp"
#include "rosgraph_msgs/msg/clock.hpp"

namespace rclcpp::detail
{

namespace
{

using ClockMessage = rosgraph_msgs::msg::Clock;
constexpr auto parameter_name = "use_sim_time";

class TimeSource
{
public:
  TimeSource(
    node_interfaces::NodeBaseInterface::WeakPtr node, Clock::SharedPtr clock, const QoS & qos)
  : node_(std::move(node)), clock_(std::move(clock)), qos_(qos)
  {
  }

  void set_active(bool active)
  {
    if (active == is_active_) {
      return;
    }
    if (active && clock_->get_clock_type() != RCL_ROS_TIME) {
      RCLCPP_ERROR(get_logger("rclcpp"), "use_sim_time has no effect on a clock that is not a ROS clock");
      return;
    }
    is_active_ = active;
    active ? begin() : end();
  }

  // Kept, so that the callbacks live as long as this.
  node_interfaces::PostSetParametersCallbackHandle::SharedPtr callback;

private:
  void begin()
  {
    {
      const std::lock_guard lock(clock_->get_clock_mutex());
      check(rcl_enable_ros_time_override(clock_->get_clock_handle()), "Failed to enable ROS time");
    }
    const auto node = node_.lock();
    if (!node) {
      return;
    }
    const auto hear = [clock = clock_](const ClockMessage & message) {
        const std::lock_guard lock(clock->get_clock_mutex());
        check(
          rcl_set_ros_time_override(clock->get_clock_handle(), Time(message.clock).nanoseconds()),
          "Failed to set ROS time");
      };
    subscription_ = std::make_shared<Subscription<ClockMessage>>(
      node, "/clock", qos_, message_handler<ClockMessage>(hear), SubscriptionOptions());
    node->add(subscription_, nullptr);
  }

  void end()
  {
    subscription_.reset();
    const std::lock_guard lock(clock_->get_clock_mutex());
    check(rcl_disable_ros_time_override(clock_->get_clock_handle()), "Failed to disable ROS time");
  }

  node_interfaces::NodeBaseInterface::WeakPtr node_;
  Clock::SharedPtr clock_;
  QoS qos_;
  bool is_active_ = false;
  Subscription<ClockMessage>::SharedPtr subscription_;
};

}  // namespace

std::shared_ptr<void> follow_sim_time(
  const node_interfaces::NodeBaseInterface::SharedPtr & node,
  const node_interfaces::NodeParametersInterface::SharedPtr & parameters,
  const Clock::SharedPtr & clock, const NodeOptions & options)
{
  const auto source = std::make_shared<TimeSource>(node, clock, options.clock_qos());
  if (!parameters->has_parameter(parameter_name)) {
    parameters->declare_parameter(parameter_name, ParameterValue(false));
  }
  const auto given = parameters->get_parameter(parameter_name);
  if (given.get_type() != PARAMETER_BOOL) {
    RCLCPP_ERROR(
      get_node_logger(node->get_rcl_node_handle()),
      "Invalid type '%s' for parameter 'use_sim_time', should be 'bool'", given.get_type_name().c_str());
    throw std::invalid_argument("Invalid type for parameter 'use_sim_time', should be 'bool'");
  }
  source->set_active(given.as_bool());
  source->callback = parameters->add_post_set_parameters_callback(
    [known = std::weak_ptr<TimeSource>(source)](const std::vector<Parameter> & changed) {
      for (const auto & parameter : changed) {
        const auto still_there = known.lock();
        if (!still_there || parameter.get_name() != parameter_name) {
          continue;
        }
        if (parameter.get_type() == PARAMETER_BOOL) {
          still_there->set_active(parameter.as_bool());
        } else if (parameter.get_type() != PARAMETER_NOT_SET) {
          RCLCPP_ERROR(
            get_logger("rclcpp"), "use_sim_time parameter cannot be set to anything but a bool");
        }
      }
    });
  return source;
}

}  // namespace rclcpp::detail
