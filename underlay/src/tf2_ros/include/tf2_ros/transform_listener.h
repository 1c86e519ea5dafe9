#pragma once

#include <memory>

#include "rclcpp/node_interfaces/getters.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/buffer_core.h"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_ros/qos.hpp"

namespace tf2_ros
{

namespace detail
{

// Parameters of the node may set their history, depth and reliability, and the first one's durability.
rclcpp::SubscriptionOptions get_default_transform_listener_sub_options();
rclcpp::SubscriptionOptions get_default_transform_listener_static_sub_options();

}  // namespace detail

/// Fills a buffer, which must live longer, with what is told on /tf and /tf_static.
class TransformListener
{
public:
  /// With a node of its own.
  explicit TransformListener(tf2::BufferCore & buffer, bool spin_thread = true);

  /// With a node, or a pointer of any kind to it. Unless it has a thread of its own, somebody must spin that.
  template<typename NodeT>
  TransformListener(
    tf2::BufferCore & buffer, NodeT && node, bool spin_thread = true,
    const rclcpp::QoS & qos = DynamicListenerQoS(), const rclcpp::QoS & static_qos = StaticListenerQoS(),
    const rclcpp::SubscriptionOptions & options = detail::get_default_transform_listener_sub_options(),
    const rclcpp::SubscriptionOptions & static_options =
    detail::get_default_transform_listener_static_sub_options())
  : TransformListener(
      buffer, rclcpp::node_interfaces::get_node_base_interface(node),
      rclcpp::node_interfaces::get_node_logging_interface(node),
      rclcpp::node_interfaces::get_node_parameters_interface(node),
      rclcpp::node_interfaces::get_node_topics_interface(node), spin_thread, qos, static_qos, options,
      static_options) {}

  TransformListener(
    tf2::BufferCore & buffer, rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
    rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging,
    rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_parameters,
    rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics, bool spin_thread = true,
    const rclcpp::QoS & qos = DynamicListenerQoS(), const rclcpp::QoS & static_qos = StaticListenerQoS(),
    const rclcpp::SubscriptionOptions & options = detail::get_default_transform_listener_sub_options(),
    const rclcpp::SubscriptionOptions & static_options =
    detail::get_default_transform_listener_static_sub_options());

  virtual ~TransformListener();

  virtual void subscription_callback(tf2_msgs::msg::TFMessage::ConstSharedPtr msg, bool is_static);

private:
  class Thread;
  struct Own
  {
    rclcpp::Node::SharedPtr node;
  };

  tf2::BufferCore & buffer_;
  rclcpp::Node::SharedPtr own_node_;
  rclcpp::CallbackGroup::SharedPtr group_;
  rclcpp::Subscription<tf2_msgs::msg::TFMessage>::SharedPtr moving_, static_;
  std::unique_ptr<Thread> thread_;

  TransformListener(tf2::BufferCore & buffer, Own own, bool spin_thread);
};

}  // namespace tf2_ros
