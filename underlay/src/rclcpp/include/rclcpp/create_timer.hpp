#pragma once

#include <utility>

#include "rclcpp/node_interfaces/node_timers_interface.hpp"
#include "rclcpp/timer.hpp"

namespace rclcpp
{

/// A timer that follows `clock`, also where that is simulated.
template<typename NodeT, typename CallbackT>
TimerBase::SharedPtr create_timer(
  NodeT node, Clock::SharedPtr clock, Duration period, CallbackT && callback,
  CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
{
  return detail::add_timer(
    *node->get_node_base_interface(), std::move(clock),
    detail::timer_period(period.to_chrono<std::chrono::nanoseconds>()),
    detail::timer_callback(std::forward<CallbackT>(callback)), group, autostart);
}

/// The same, of parts of a node.
template<typename CallbackT>
TimerBase::SharedPtr create_timer(
  std::shared_ptr<node_interfaces::NodeBaseInterface> node_base,
  std::shared_ptr<node_interfaces::NodeTimersInterface>, Clock::SharedPtr clock, Duration period,
  CallbackT && callback, CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
{
  return detail::add_timer(
    *node_base, std::move(clock), detail::timer_period(period.to_chrono<std::chrono::nanoseconds>()),
    detail::timer_callback(std::forward<CallbackT>(callback)), group, autostart);
}
template<typename Rep, typename Period, typename CallbackT>
TimerBase::SharedPtr create_timer(
  Clock::SharedPtr clock, std::chrono::duration<Rep, Period> period, CallbackT && callback,
  CallbackGroup::SharedPtr group, node_interfaces::NodeBaseInterface * node_base,
  node_interfaces::NodeTimersInterface *, bool autostart = true)
{
  return detail::add_timer(
    *node_base, std::move(clock), detail::timer_period(period),
    detail::timer_callback(std::forward<CallbackT>(callback)), group, autostart);
}

/// A timer of real time.
template<typename NodeT, typename Rep, typename Period, typename CallbackT>
TimerBase::SharedPtr create_wall_timer(
  std::chrono::duration<Rep, Period> period, CallbackT && callback, CallbackGroup::SharedPtr group,
  NodeT * node_base, void * = nullptr, bool autostart = true)
{
  return detail::add_timer(
    *node_base, std::make_shared<Clock>(RCL_STEADY_TIME), detail::timer_period(period),
    detail::timer_callback(std::forward<CallbackT>(callback)), group, autostart);
}

}  // namespace rclcpp
