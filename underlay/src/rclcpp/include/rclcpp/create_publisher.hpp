#pragma once

#include <memory>
#include <string>
#include <type_traits>

#include "rclcpp/detail/node_of.hpp"

namespace rclcpp
{

template<typename MessageT, typename AllocatorT = std::allocator<void>, typename NodeT>
std::shared_ptr<Publisher<MessageT, AllocatorT>> create_publisher(
  NodeT && node, const std::string & topic_name, const QoS & qos,
  const PublisherOptionsWithAllocator<AllocatorT> & options =
  PublisherOptionsWithAllocator<AllocatorT>())
{
  auto & given = detail::node_of(node);
  if constexpr (std::is_same_v<std::decay_t<decltype(given)>, node_interfaces::NodeTopicsInterface>) {
    return std::make_shared<Publisher<MessageT, AllocatorT>>(
      given.get_node_base_interface(), topic_name, qos, options);
  } else {
    return given.template create_publisher<MessageT, AllocatorT>(topic_name, qos, options);
  }
}

}  // namespace rclcpp
