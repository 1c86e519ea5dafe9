#include <algorithm>

#include "rclcpp/detail/qos_parameters.hpp"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"

namespace tf2_ros
{

using geometry_msgs::msg::TransformStamped;
using tf2_msgs::msg::TFMessage;

namespace
{

rclcpp::Publisher<TFMessage>::SharedPtr publisher_of(
  const char * topic, const rclcpp::node_interfaces::NodeParametersInterface::SharedPtr & parameters,
  const rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr & topics, const rclcpp::QoS & qos,
  const rclcpp::PublisherOptions & options)
{
  const auto overridden = rclcpp::detail::declare_qos_parameters(
    options.qos_overriding_options, parameters, topics->resolve_topic_name(topic), qos,
    rclcpp::detail::PublisherQosParametersTraits());
  return rclcpp::create_publisher<TFMessage>(topics, topic, overridden, options);
}

}  // namespace

rclcpp::PublisherOptions detail::broadcaster_options(bool with_durability)
{
  using Kind = rclcpp::QosPolicyKind;
  rclcpp::PublisherOptions options;
  options.qos_overriding_options = with_durability ?
    rclcpp::QosOverridingOptions{Kind::Depth, Kind::Durability, Kind::History, Kind::Reliability} :
    rclcpp::QosOverridingOptions{Kind::Depth, Kind::History, Kind::Reliability};
  return options;
}

TransformBroadcaster::TransformBroadcaster(
  rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_parameters,
  rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics, const rclcpp::QoS & qos,
  const rclcpp::PublisherOptions & options)
: publisher_(publisher_of("/tf", node_parameters, node_topics, qos, options)) {}

void TransformBroadcaster::sendTransform(const TransformStamped & transform)
{
  sendTransform(std::vector<TransformStamped>{transform});
}

void TransformBroadcaster::sendTransform(const std::vector<TransformStamped> & transforms)
{
  TFMessage message;
  message.transforms = transforms;
  publisher_->publish(message);
}

StaticTransformBroadcaster::StaticTransformBroadcaster(
  rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_parameters,
  rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics, const rclcpp::QoS & qos,
  const rclcpp::PublisherOptions & options)
: publisher_(publisher_of("/tf_static", node_parameters, node_topics, qos, options)) {}

void StaticTransformBroadcaster::sendTransform(const TransformStamped & transform)
{
  sendTransform(std::vector<TransformStamped>{transform});
}

void StaticTransformBroadcaster::sendTransform(const std::vector<TransformStamped> & transforms)
{
  auto & sent = sent_.transforms;
  for (const auto & transform : transforms) {
    const auto earlier = std::find_if(
      sent.begin(), sent.end(), [&transform](const TransformStamped & other) {
        return other.child_frame_id == transform.child_frame_id;
      });
    if (earlier == sent.end()) {
      sent.push_back(transform);
    } else {
      *earlier = transform;
    }
  }
  publisher_->publish(sent_);
}

}  // namespace tf2_ros
