#pragma once

#include <memory>
#include <stdexcept>
#include <type_traits>

#include "rclcpp/loaned_message.hpp"
#include "rclcpp/publisher_base.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace rclcpp
{

template<typename MessageT, typename AllocatorT = std::allocator<void>>
class Publisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Publisher<MessageT, AllocatorT>)
  using ROSMessageType = MessageT;
  using PublishedType = MessageT;
  using MessageAllocator = std::allocator<MessageT>;
  using MessageDeleter = std::default_delete<MessageT>;
  using MessageUniquePtr = std::unique_ptr<MessageT>;
  using MessageSharedPtr = std::shared_ptr<const MessageT>;

  Publisher(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic, const QoS & qos,
    const PublisherOptionsWithAllocator<AllocatorT> & options)
  : PublisherBase(
      node, topic, *rosidl_typesupport_cpp::get_message_type_support_handle<MessageT>(), qos, options)
  {
  }

  void publish(const MessageT & message) {publish_untyped(&message);}
  void publish(MessageUniquePtr message) {publish_untyped(message.get());}
  void publish(const SerializedMessage & message)
  {
    publish_serialized(message.get_rcl_serialized_message());
  }
  void publish(const rcl_serialized_message_t & message) {publish_serialized(message);}

  /// A message to be filled in, and then given to publish.
  LoanedMessage<MessageT, AllocatorT> borrow_loaned_message()
  {
    return LoanedMessage<MessageT, AllocatorT>(*this);
  }
  /// Throws std::runtime_error when it was given away before.
  void publish(LoanedMessage<MessageT, AllocatorT> && message)
  {
    if (!message.is_valid()) {
      throw std::runtime_error("loaned message is not valid");
    }
    publish_untyped(message.release().get());
  }
};

}  // namespace rclcpp
