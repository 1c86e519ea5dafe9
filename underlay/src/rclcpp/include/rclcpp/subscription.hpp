#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/any_subscription_callback.hpp"
#include "rclcpp/subscription_base.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace rclcpp
{

template<typename MessageT, typename AllocatorT = std::allocator<void>>
class Subscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Subscription<MessageT, AllocatorT>)
  using SubscribedType = MessageT;
  using ROSMessageType = MessageT;
  using MessageUniquePtr = std::unique_ptr<MessageT>;

  Subscription(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic, const QoS & qos,
    detail::MessageHandler<MessageT> handler, const SubscriptionOptionsWithAllocator<AllocatorT> & options)
  : SubscriptionBase(
      node, topic, *rosidl_typesupport_cpp::get_message_type_support_handle<MessageT>(), qos, options),
    handler_(std::move(handler))
  {
  }

  /// With a callback that takes the bytes.
  Subscription(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic, const QoS & qos,
    detail::SerializedHandler handler, const SubscriptionOptionsWithAllocator<AllocatorT> & options)
  : SubscriptionBase(
      node, topic, *rosidl_typesupport_cpp::get_message_type_support_handle<MessageT>(), qos, options, true),
    serialized_handler_(std::move(handler))
  {
  }

  /// Takes the next message without an executor; false when there is none.
  bool take(MessageT & message_out, MessageInfo & message_info_out)
  {
    return take_type_erased(&message_out, message_info_out);
  }

  std::shared_ptr<void> create_message() override {return std::make_shared<MessageT>();}

  void handle_message(std::shared_ptr<void> & message, const MessageInfo & message_info) override
  {
    handler_(std::static_pointer_cast<MessageT>(std::move(message)), message_info);
  }

  void handle_serialized_message(
    const std::shared_ptr<SerializedMessage> & message, const MessageInfo & message_info) override
  {
    serialized_handler_(std::shared_ptr<SerializedMessage>(message), message_info);
  }

private:
  detail::MessageHandler<MessageT> handler_;
  detail::SerializedHandler serialized_handler_;
};

}  // namespace rclcpp
