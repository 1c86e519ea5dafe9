#pragma once

#include <cstddef>
#include <memory>

#include "rclcpp/allocator/allocator_common.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/serialized_message.hpp"

namespace rclcpp::message_memory_strategy
{

/// Makes messages with an allocator. Subscriptions take one, but make their messages by themselves.
template<typename MessageT, typename Alloc = std::allocator<void>>
class MessageMemoryStrategy
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MessageMemoryStrategy)
  using MessageAllocTraits = allocator::AllocRebind<MessageT, Alloc>;
  using MessageAlloc = typename MessageAllocTraits::allocator_type;
  using MessageDeleter = allocator::Deleter<MessageAlloc, MessageT>;
  using SerializedMessageAlloc =
    typename allocator::AllocRebind<SerializedMessage, Alloc>::allocator_type;
  using BufferAlloc = typename allocator::AllocRebind<char, Alloc>::allocator_type;

  MessageMemoryStrategy() : MessageMemoryStrategy(std::make_shared<Alloc>()) {}
  explicit MessageMemoryStrategy(std::shared_ptr<Alloc> allocator)
  : message_allocator_(std::make_shared<MessageAlloc>(*allocator)),
    serialized_message_allocator_(std::make_shared<SerializedMessageAlloc>(*allocator)),
    buffer_allocator_(std::make_shared<BufferAlloc>(*allocator)),
    rcutils_allocator_(allocator::get_rcl_allocator<char>(*buffer_allocator_))
  {
  }
  virtual ~MessageMemoryStrategy() = default;

  static SharedPtr create_default() {return std::make_shared<MessageMemoryStrategy>();}

  virtual std::shared_ptr<MessageT> borrow_message()
  {
    return std::allocate_shared<MessageT>(*message_allocator_);
  }
  virtual std::shared_ptr<SerializedMessage> borrow_serialized_message(std::size_t capacity)
  {
    return std::make_shared<SerializedMessage>(capacity);
  }
  virtual std::shared_ptr<SerializedMessage> borrow_serialized_message()
  {
    return borrow_serialized_message(default_buffer_capacity_);
  }
  virtual void set_default_buffer_capacity(std::size_t capacity) {default_buffer_capacity_ = capacity;}
  virtual void return_message(std::shared_ptr<MessageT> & message) {message.reset();}
  virtual void return_serialized_message(std::shared_ptr<SerializedMessage> & message) {message.reset();}

  std::shared_ptr<MessageAlloc> message_allocator_;
  std::shared_ptr<SerializedMessageAlloc> serialized_message_allocator_;
  std::shared_ptr<BufferAlloc> buffer_allocator_;
  std::size_t default_buffer_capacity_ = 0;
  rcutils_allocator_t rcutils_allocator_;
};

}  // namespace rclcpp::message_memory_strategy
