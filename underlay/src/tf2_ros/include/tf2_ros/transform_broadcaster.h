#pragma once

#include <vector>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/node_interfaces/getters.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_ros/qos.hpp"

namespace tf2_ros
{

namespace detail
{

/// Parameters of the node may set its history, depth, reliability and, if `with_durability`, durability.
rclcpp::PublisherOptions broadcaster_options(bool with_durability);

}  // namespace detail

/// Tells on /tf where frames are now.
class TransformBroadcaster
{
public:
  /// The node, or a pointer of any kind to it.
  template<typename NodeT>
  TransformBroadcaster(  // NOLINT: as the real one has it
    NodeT && node, const rclcpp::QoS & qos = DynamicBroadcasterQoS(),
    const rclcpp::PublisherOptions & options = detail::broadcaster_options(true))
  : TransformBroadcaster(
      rclcpp::node_interfaces::get_node_parameters_interface(node),
      rclcpp::node_interfaces::get_node_topics_interface(node), qos, options) {}

  TransformBroadcaster(
    rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_parameters,
    rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics,
    const rclcpp::QoS & qos = DynamicBroadcasterQoS(),
    const rclcpp::PublisherOptions & options = detail::broadcaster_options(true));

  void sendTransform(const geometry_msgs::msg::TransformStamped & transform);
  void sendTransform(const std::vector<geometry_msgs::msg::TransformStamped> & transforms);

private:
  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr publisher_;
};

}  // namespace tf2_ros
