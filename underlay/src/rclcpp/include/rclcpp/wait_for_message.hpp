#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "rclcpp/node.hpp"

namespace rclcpp
{

namespace detail
{

/// Waits until the subscription can take something; a negative time waits for ever. False when it cannot.
bool wait_for_subscription(
  const std::shared_ptr<SubscriptionBase> & subscription, const Context::SharedPtr & context,
  std::chrono::nanoseconds time_to_wait);

}  // namespace detail

/// Takes the next message, without an executor. False when the time is over, or the context has ended.
template<class MsgT, class Rep = std::int64_t, class Period = std::milli>
bool wait_for_message(
  MsgT & out, std::shared_ptr<Subscription<MsgT>> subscription, Context::SharedPtr context,
  std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1))
{
  MessageInfo info;
  return detail::wait_for_subscription(
    subscription, context, std::chrono::duration_cast<std::chrono::nanoseconds>(time_to_wait)) &&
         subscription->take(out, info);
}

template<class MsgT, class Rep = std::int64_t, class Period = std::milli>
bool wait_for_message(
  MsgT & out, Node::SharedPtr node, const std::string & topic,
  std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1),
  const QoS & qos = SystemDefaultsQoS())
{
  // In a group of no executor, which would take the message away.
  SubscriptionOptions options;
  options.use_intra_process_comm = IntraProcessSetting::Disable;
  options.callback_group =
    node->create_callback_group(CallbackGroupType::MutuallyExclusive, false);
  const auto subscription = node->create_subscription<MsgT>(topic, qos, [](const MsgT &) {}, options);
  return wait_for_message(
    out, subscription, node->get_node_base_interface()->get_context(), time_to_wait);
}

}  // namespace rclcpp
