#pragma once

#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "rclcpp/allocator/allocator_common.hpp"
#include "rclcpp/loaned_message.hpp"
#include "rclcpp/publisher_base.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/type_adapter.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace rclcpp
{

template<typename MessageT, typename AllocatorT = std::allocator<void>>
class Publisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Publisher<MessageT, AllocatorT>)
  using Adapter = TypeAdapter<MessageT>;
  using ROSMessageType = typename Adapter::ros_message_type;
  using PublishedType = typename Adapter::custom_type;
  using MessageAllocator =
    typename allocator::AllocRebind<ROSMessageType, AllocatorT>::allocator_type;
  using MessageDeleter = allocator::Deleter<MessageAllocator, ROSMessageType>;
  using MessageUniquePtr = std::unique_ptr<ROSMessageType, MessageDeleter>;
  using MessageSharedPtr = std::shared_ptr<const ROSMessageType>;

  Publisher(
    const node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & topic, const QoS & qos,
    const PublisherOptionsWithAllocator<AllocatorT> & options)
  : PublisherBase(
      node, topic, *rosidl_typesupport_cpp::get_message_type_support_handle<ROSMessageType>(), qos,
      options, &detail::clone_message<ROSMessageType>)
  {
  }

  void publish(const ROSMessageType & message) {publish_untyped(&message);}
  /// The message itself reaches a subscription of this process that wants it and hands messages over, unless
  /// it is of an allocator.
  void publish(MessageUniquePtr message)
  {
    if constexpr (std::is_same_v<MessageDeleter, std::default_delete<ROSMessageType>>) {
      publish_unique(std::move(message));
    } else {
      publish_untyped(message.get());
    }
  }

  // What an adapter makes a message of.
  template<
    typename T,
    std::enable_if_t<Adapter::is_specialized::value && std::is_same_v<T, PublishedType>, int> = 0>
  void publish(const T & custom)
  {
    auto message = std::make_unique<ROSMessageType>();
    Adapter::convert_to_ros_message(custom, *message);
    publish_unique(std::move(message));
  }
  template<
    typename T,
    std::enable_if_t<Adapter::is_specialized::value && std::is_same_v<T, PublishedType>, int> = 0>
  void publish(std::unique_ptr<T> custom)
  {
    publish(*custom);
  }

  void publish(const SerializedMessage & message)
  {
    publish_serialized(message.get_rcl_serialized_message());
  }
  void publish(const rcl_serialized_message_t & message) {publish_serialized(message);}

  /// A message to be filled in, and then given to publish.
  LoanedMessage<ROSMessageType, AllocatorT> borrow_loaned_message()
  {
    return LoanedMessage<ROSMessageType, AllocatorT>(*this);
  }
  /// Throws std::runtime_error when it was given away before.
  void publish(LoanedMessage<ROSMessageType, AllocatorT> && message)
  {
    if (!message.is_valid()) {
      throw std::runtime_error("loaned message is not valid");
    }
    publish_untyped(message.release().get());
  }

private:
  void publish_unique(std::unique_ptr<ROSMessageType> message)
  {
    if (hands_over()) {
      publish_owned(detail::shared_from_unique(std::move(message)));
    } else {
      publish_untyped(message.get());
    }
  }
};

}  // namespace rclcpp
