#pragma once

#include <chrono>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "rclcpp/node_interfaces/getters.hpp"
#include "rclcpp/timer.hpp"

namespace rclcpp
{

namespace detail
{

template<typename TimerT>
std::shared_ptr<TimerT> add_timer(
  std::shared_ptr<TimerT> timer, const CallbackGroup::SharedPtr & group,
  node_interfaces::NodeTimersInterface & node_timers)
{
  node_timers.add_timer(timer, group);
  return timer;
}

template<typename PartT>
PartT & not_null(PartT * part, const char * message)
{
  if (!part) {
    throw std::invalid_argument(message);
  }
  return *part;
}

}  // namespace detail

/// A timer of real time. Throws std::invalid_argument for a bad period and for null pointers.
template<typename Rep, typename Period, typename CallbackT>
typename WallTimer<std::decay_t<CallbackT>>::SharedPtr create_wall_timer(
  std::chrono::duration<Rep, Period> period, CallbackT && callback, CallbackGroup::SharedPtr group,
  node_interfaces::NodeBaseInterface * node_base, node_interfaces::NodeTimersInterface * node_timers,
  bool autostart = true)
{
  auto & node = detail::not_null(node_base, "input node_base cannot be null");
  auto & timers = detail::not_null(node_timers, "input node_timers cannot be null");
  return detail::add_timer(
    std::make_shared<WallTimer<std::decay_t<CallbackT>>>(
      detail::timer_period(period), std::forward<CallbackT>(callback), node.get_context(), autostart),
    group, timers);
}

/// A timer that follows `clock`, also where that is simulated. Throws as above.
template<typename Rep, typename Period, typename CallbackT>
typename GenericTimer<std::decay_t<CallbackT>>::SharedPtr create_timer(
  Clock::SharedPtr clock, std::chrono::duration<Rep, Period> period, CallbackT && callback,
  CallbackGroup::SharedPtr group, node_interfaces::NodeBaseInterface * node_base,
  node_interfaces::NodeTimersInterface * node_timers, bool autostart = true)
{
  detail::not_null(clock.get(), "clock cannot be null");
  auto & node = detail::not_null(node_base, "input node_base cannot be null");
  auto & timers = detail::not_null(node_timers, "input node_timers cannot be null");
  return detail::add_timer(
    std::make_shared<GenericTimer<std::decay_t<CallbackT>>>(
      std::move(clock), detail::timer_period(period), std::forward<CallbackT>(callback),
      node.get_context(), autostart),
    group, timers);
}

/// The same, of parts of a node.
template<typename CallbackT>
TimerBase::SharedPtr create_timer(
  std::shared_ptr<node_interfaces::NodeBaseInterface> node_base,
  std::shared_ptr<node_interfaces::NodeTimersInterface> node_timers, Clock::SharedPtr clock,
  Duration period, CallbackT && callback, CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
{
  return create_timer(
    std::move(clock), period.to_chrono<std::chrono::nanoseconds>(), std::forward<CallbackT>(callback),
    std::move(group), node_base.get(), node_timers.get(), autostart);
}

/// The same, of a node.
template<typename NodeT, typename CallbackT>
TimerBase::SharedPtr create_timer(
  NodeT && node, Clock::SharedPtr clock, Duration period, CallbackT && callback,
  CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
{
  return create_timer(
    node_interfaces::get_node_base_interface(node), node_interfaces::get_node_timers_interface(node),
    std::move(clock), period, std::forward<CallbackT>(callback), std::move(group), autostart);
}

}  // namespace rclcpp
