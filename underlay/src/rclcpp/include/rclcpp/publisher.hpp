#pragma once

#include <memory>
#include <type_traits>

#include "rclcpp/publisher_base.hpp"
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
};

}  // namespace rclcpp
