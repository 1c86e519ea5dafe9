#pragma once

#include <mutex>
#include <unordered_map>

#include "tf2_ros/create_timer_interface.h"

namespace tf2_ros
{

/// With timers of a node.
class CreateTimerROS : public CreateTimerInterface
{
public:
  CreateTimerROS(
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
    rclcpp::node_interfaces::NodeTimersInterface::SharedPtr node_timers,
    rclcpp::CallbackGroup::SharedPtr callback_group = nullptr);

  TimerHandle createTimer(
    rclcpp::Clock::SharedPtr clock, const tf2::Duration & period, TimerCallbackType callback) override;
  void cancel(const TimerHandle & timer_handle) override;
  void reset(const TimerHandle & timer_handle) override;
  void remove(const TimerHandle & timer_handle) override;

private:
  rclcpp::TimerBase::SharedPtr timer(const TimerHandle & timer_handle, const char * function);

  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base_;
  rclcpp::node_interfaces::NodeTimersInterface::SharedPtr node_timers_;
  rclcpp::CallbackGroup::SharedPtr callback_group_;
  std::mutex mutex_;
  TimerHandle last_handle_ = 0;
  std::unordered_map<TimerHandle, rclcpp::TimerBase::SharedPtr> timers_;
};

}  // namespace tf2_ros
