#pragma once

#include <cstddef>

#include "rclcpp/qos.hpp"

namespace tf2_ros
{

struct DynamicListenerQoS : rclcpp::QoS
{
  explicit DynamicListenerQoS(std::size_t depth = 100) : QoS(depth) {}
};

struct DynamicBroadcasterQoS : rclcpp::QoS
{
  explicit DynamicBroadcasterQoS(std::size_t depth = 100) : QoS(depth) {}
};

/// Of static frames each broadcaster has told once, maybe long ago.
struct StaticListenerQoS : rclcpp::QoS
{
  explicit StaticListenerQoS(std::size_t depth = 100) : QoS(depth) {transient_local();}
};

struct StaticBroadcasterQoS : rclcpp::QoS
{
  explicit StaticBroadcasterQoS(std::size_t depth = 1) : QoS(depth) {transient_local();}
};

}  // namespace tf2_ros
