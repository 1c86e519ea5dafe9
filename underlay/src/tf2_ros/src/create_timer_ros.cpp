#include "tf2_ros/create_timer_ros.h"

#include <exception>
#include <string>
#include <utility>

namespace tf2_ros
{

CreateTimerROS::CreateTimerROS(
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
  rclcpp::node_interfaces::NodeTimersInterface::SharedPtr node_timers,
  rclcpp::CallbackGroup::SharedPtr callback_group)
: node_base_(std::move(node_base)), node_timers_(std::move(node_timers)),
  callback_group_(std::move(callback_group)) {}

TimerHandle CreateTimerROS::createTimer(
  rclcpp::Clock::SharedPtr clock, const tf2::Duration & period, TimerCallbackType callback)
{
  const std::lock_guard lock(mutex_);
  try {
    const TimerHandle handle = ++last_handle_;
    timers_[handle] = rclcpp::create_timer(
      node_base_, node_timers_, clock, rclcpp::Duration(period),
      [handle, callback = std::move(callback)] {callback(handle);}, callback_group_);
    return handle;
  } catch (const std::exception & error) {
    timers_.erase(last_handle_);
    throw CreateTimerInterfaceException(error.what());
  }
}

void CreateTimerROS::cancel(const TimerHandle & timer_handle) {timer(timer_handle, "cancel")->cancel();}

void CreateTimerROS::reset(const TimerHandle & timer_handle) {timer(timer_handle, "reset")->reset();}

void CreateTimerROS::remove(const TimerHandle & timer_handle)
{
  timer(timer_handle, "remove")->cancel();
  const std::lock_guard lock(mutex_);
  timers_.erase(timer_handle);
}

rclcpp::TimerBase::SharedPtr CreateTimerROS::timer(const TimerHandle & timer_handle, const char * function)
{
  const std::lock_guard lock(mutex_);
  const auto found = timers_.find(timer_handle);
  if (found == timers_.end()) {
    throw InvalidTimerHandleException(std::string("Invalid timer handle in ") + function + "()");
  }
  return found->second;
}

}  // namespace tf2_ros
