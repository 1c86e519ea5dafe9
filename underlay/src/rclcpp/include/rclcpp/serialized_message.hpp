#pragma once

#include <cstddef>
#include <memory>

#include "rcl/allocator.h"
#include "rcl/types.h"

namespace rclcpp
{

/// The bytes of a message, as they are sent.
class SerializedMessage
{
public:
  explicit SerializedMessage(const rcl_allocator_t & allocator = rcl_get_default_allocator());
  explicit SerializedMessage(
    std::size_t initial_capacity, const rcl_allocator_t & allocator = rcl_get_default_allocator());
  SerializedMessage(const SerializedMessage & other);
  explicit SerializedMessage(const rcl_serialized_message_t & other);
  SerializedMessage(SerializedMessage && other) noexcept;
  explicit SerializedMessage(rcl_serialized_message_t && other) noexcept;
  SerializedMessage & operator=(const SerializedMessage & other);
  SerializedMessage & operator=(const rcl_serialized_message_t & other);
  SerializedMessage & operator=(SerializedMessage && other) noexcept;
  SerializedMessage & operator=(rcl_serialized_message_t && other) noexcept;
  virtual ~SerializedMessage();

  rcl_serialized_message_t & get_rcl_serialized_message() {return message_;}
  const rcl_serialized_message_t & get_rcl_serialized_message() const {return message_;}
  std::size_t size() const {return message_.buffer_length;}
  std::size_t capacity() const {return message_.buffer_capacity;}

  /// Makes room; what is there stays.
  void reserve(std::size_t capacity);

  /// Hands the bytes over to the caller, who must free them.
  rcl_serialized_message_t release_rcl_serialized_message();

private:
  rcl_serialized_message_t message_;
};

}  // namespace rclcpp
