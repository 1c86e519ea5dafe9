#pragma once

#include <memory>
#include <string>

#include "rclcpp/detail/node_of.hpp"

namespace rclcpp
{

template<typename MessageT, typename AllocatorT = std::allocator<void>, typename NodeT>
std::shared_ptr<Publisher<MessageT, AllocatorT>> create_publisher(
  NodeT && node, const std::string & topic_name, const QoS & qos,
  const PublisherOptionsWithAllocator<AllocatorT> & options =
  PublisherOptionsWithAllocator<AllocatorT>())
{
  return detail::node_of(node).template create_publisher<MessageT, AllocatorT>(topic_name, qos, options);
}

}  // namespace rclcpp
