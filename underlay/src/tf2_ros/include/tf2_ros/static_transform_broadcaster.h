#pragma once

#include <vector>

#include "tf2_ros/transform_broadcaster.h"

namespace tf2_ros
{

/// Tells on /tf_static where frames are for good, also those who come later.
class StaticTransformBroadcaster
{
public:
  /// The node, or a pointer of any kind to it.
  template<typename NodeT>
  StaticTransformBroadcaster(  // NOLINT: as the real one has it
    NodeT && node, const rclcpp::QoS & qos = StaticBroadcasterQoS(),
    const rclcpp::PublisherOptions & options = detail::broadcaster_options(false))
  : StaticTransformBroadcaster(
      rclcpp::node_interfaces::get_node_parameters_interface(node),
      rclcpp::node_interfaces::get_node_topics_interface(node), qos, options) {}

  StaticTransformBroadcaster(
    rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_parameters,
    rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics,
    const rclcpp::QoS & qos = StaticBroadcasterQoS(),
    const rclcpp::PublisherOptions & options = detail::broadcaster_options(false));

  // Frames that were sent before are sent again, with these in place of their earlier ones.
  void sendTransform(const geometry_msgs::msg::TransformStamped & transform);
  void sendTransform(const std::vector<geometry_msgs::msg::TransformStamped> & transforms);

private:
  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr publisher_;
  tf2_msgs::msg::TFMessage sent_;
};

}  // namespace tf2_ros
