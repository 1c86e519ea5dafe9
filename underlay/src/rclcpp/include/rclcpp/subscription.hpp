#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/any_subscription_callback.hpp"
#include "rclcpp/subscription_base.hpp"
#include "rclcpp/subscription_traits.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace rclcpp
{

template<typename MessageT, typename AllocatorT = std::allocator<void>>
class Subscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Subscription<MessageT, AllocatorT>)
  using SubscribedType = typename TypeAdapter<MessageT>::custom_type;
  using ROSMessageType = typename TypeAdapter<MessageT>::ros_message_type;
  using MessageUniquePtr = std::unique_ptr<SubscribedType>;

  Subscription(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic, const QoS & qos,
    detail::MessageHandler<ROSMessageType> handler, const SubscriptionOptionsWithAllocator<AllocatorT> & options)
  : SubscriptionBase(
      node, topic, *rosidl_typesupport_cpp::get_message_type_support_handle<ROSMessageType>(), qos,
      options,
      handler.owns_messages ? Form::owned : Form::shared),
    handler_(std::move(handler))
  {
  }

  /// With a callback that takes the bytes.
  Subscription(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic, const QoS & qos,
    detail::SerializedHandler handler, const SubscriptionOptionsWithAllocator<AllocatorT> & options)
  : SubscriptionBase(
      node, topic, *rosidl_typesupport_cpp::get_message_type_support_handle<ROSMessageType>(), qos,
      options,
      Form::bytes),
    serialized_handler_(std::move(handler))
  {
  }

  /// Takes the next message without an executor; false when there is none.
  bool take(ROSMessageType & message_out, MessageInfo & message_info_out)
  {
    return take_type_erased(&message_out, message_info_out);
  }

  /// The same, as the adapter has it.
  template<
    typename T, std::enable_if_t<
      TypeAdapter<MessageT>::is_specialized::value && std::is_same_v<T, SubscribedType>, int> = 0>
  bool take(T & message_out, MessageInfo & message_info_out)
  {
    ROSMessageType message;
    const bool is_there = take(message, message_info_out);
    if (is_there) {
      TypeAdapter<MessageT>::convert_to_custom(message, message_out);
    }
    return is_there;
  }

  std::shared_ptr<void> create_message() override {return std::make_shared<ROSMessageType>();}

  void handle_message(std::shared_ptr<void> & message, const MessageInfo & message_info) override
  {
    auto only = std::static_pointer_cast<ROSMessageType>(message);
    message.reset();  // so that the callback may have it to itself
    handler_(std::move(only), message_info);
  }

  void handle_serialized_message(
    const std::shared_ptr<SerializedMessage> & message, const MessageInfo & message_info) override
  {
    serialized_handler_(std::shared_ptr<SerializedMessage>(message), message_info);
  }

private:
  detail::MessageHandler<ROSMessageType> handler_;
  detail::SerializedHandler serialized_handler_;
};

}  // namespace rclcpp
