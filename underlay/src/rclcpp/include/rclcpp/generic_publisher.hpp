#pragma once

#include <memory>
#include <string>

#include "rclcpp/publisher_base.hpp"
#include "rclcpp/serialized_message.hpp"

namespace rclcpp
{

/// A publisher of messages whose type is known by its name alone.
class GenericPublisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericPublisher)

  GenericPublisher(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
    const std::string & topic_type, const QoS & qos, const PublisherOptionsBase & options);

  void publish(const SerializedMessage & message);
  /// Publishes it in memory of the middleware. Throws RCLError if the middleware loans none.
  void publish_as_loaned_msg(const SerializedMessage & message);

private:
  GenericPublisher(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
    const rosidl_message_type_support_t & type_support, const QoS & qos,
    const PublisherOptionsBase & options);

  const rosidl_message_type_support_t & type_support_;
};

}  // namespace rclcpp
