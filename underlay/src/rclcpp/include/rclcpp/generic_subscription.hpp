#pragma once

#include <memory>
#include <string>

#include "rclcpp/any_subscription_callback.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/subscription_base.hpp"

namespace rclcpp
{

/// A subscription of messages whose type is known by its name alone: they come as bytes.
class GenericSubscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericSubscription)

  GenericSubscription(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic,
    const std::string & topic_type, const QoS & qos, detail::MessageHandler<SerializedMessage> handler,
    const SubscriptionOptionsBase & options);

  /// Not for messages that are no bytes: these two throw UnimplementedError.
  std::shared_ptr<void> create_message() override;
  void handle_message(std::shared_ptr<void> & message, const MessageInfo & message_info) override;
  void handle_serialized_message(
    const std::shared_ptr<SerializedMessage> & message, const MessageInfo & message_info) override;

private:
  detail::MessageHandler<SerializedMessage> handler_;
};

}  // namespace rclcpp
