#pragma once

#include <type_traits>

#include "rclcpp/node.hpp"

namespace rclcpp::detail
{

/// The node, of which a pointer of any kind or a reference is given.
template<typename NodeT>
auto & node_of(NodeT && node)
{
  if constexpr (std::is_base_of_v<Node, std::decay_t<NodeT>>) {
    return node;
  } else {
    return *node;
  }
}

}  // namespace rclcpp::detail
