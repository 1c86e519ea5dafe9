#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/detail/node_of.hpp"

namespace rclcpp
{

template<typename MessageT, typename CallbackT, typename AllocatorT = std::allocator<void>, typename NodeT>
std::shared_ptr<Subscription<MessageT, AllocatorT>> create_subscription(
  NodeT && node, const std::string & topic_name, const QoS & qos, CallbackT && callback,
  const SubscriptionOptionsWithAllocator<AllocatorT> & options =
  SubscriptionOptionsWithAllocator<AllocatorT>())
{
  return detail::node_of(node).template create_subscription<MessageT>(
    topic_name, qos, std::forward<CallbackT>(callback), options);
}

}  // namespace rclcpp
