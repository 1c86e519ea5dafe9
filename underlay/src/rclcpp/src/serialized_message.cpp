#include "rclcpp/serialized_message.hpp"

#include <cstring>
#include <utility>

#include "rclcpp/detail/check.hpp"
#include "rclcpp/serialization.hpp"
#include "rcpputils/asserts.hpp"
#include "rmw/rmw.h"
#include "rmw/serialized_message.h"

namespace rclcpp
{

namespace
{

rcl_serialized_message_t made(std::size_t capacity, const rcl_allocator_t & allocator)
{
  auto message = rmw_get_zero_initialized_serialized_message();
  detail::check(
    rmw_serialized_message_init(&message, capacity, &allocator), "failed to make a serialized message");
  return message;
}

rcl_serialized_message_t copied(const rcl_serialized_message_t & other)
{
  auto message = made(other.buffer_capacity, other.allocator);
  if (other.buffer_length != 0) {
    std::memcpy(message.buffer, other.buffer, other.buffer_length);
  }
  message.buffer_length = other.buffer_length;
  return message;
}

rcl_serialized_message_t taken(rcl_serialized_message_t & other) noexcept
{
  return std::exchange(other, rmw_get_zero_initialized_serialized_message());
}

}  // namespace

SerializedMessage::SerializedMessage(const rcl_allocator_t & allocator)
: SerializedMessage(0u, allocator)
{
}

SerializedMessage::SerializedMessage(std::size_t initial_capacity, const rcl_allocator_t & allocator)
: message_(made(initial_capacity, allocator))
{
}

SerializedMessage::SerializedMessage(const SerializedMessage & other)
: SerializedMessage(other.message_)
{
}

SerializedMessage::SerializedMessage(const rcl_serialized_message_t & other)
: message_(copied(other))
{
}

SerializedMessage::SerializedMessage(SerializedMessage && other) noexcept
: message_(taken(other.message_))
{
}

SerializedMessage::SerializedMessage(rcl_serialized_message_t && other) noexcept
: message_(taken(other))
{
}

SerializedMessage & SerializedMessage::operator=(const SerializedMessage & other)
{
  return *this = SerializedMessage(other);
}

SerializedMessage & SerializedMessage::operator=(const rcl_serialized_message_t & other)
{
  return *this = SerializedMessage(other);
}

SerializedMessage & SerializedMessage::operator=(SerializedMessage && other) noexcept
{
  SerializedMessage owner(std::move(other));  // so that `other` is left empty
  std::swap(message_, owner.message_);
  return *this;
}

SerializedMessage & SerializedMessage::operator=(rcl_serialized_message_t && other) noexcept
{
  return *this = SerializedMessage(std::move(other));
}

SerializedMessage::~SerializedMessage()
{
  if (message_.buffer && rmw_serialized_message_fini(&message_) != RMW_RET_OK) {
    rcl_reset_error();
  }
}

void SerializedMessage::reserve(std::size_t capacity)
{
  detail::check(
    rmw_serialized_message_resize(&message_, capacity), "failed to make room in a serialized message");
}

rcl_serialized_message_t SerializedMessage::release_rcl_serialized_message()
{
  return taken(message_);
}

SerializationBase::SerializationBase(const rosidl_message_type_support_t * type_support)
: type_support_(type_support)
{
  rcpputils::check_true(type_support != nullptr, "Typesupport is nullpointer.");
}

void SerializationBase::serialize_message(
  const void * ros_message, SerializedMessage * serialized_message) const
{
  rcpputils::check_true(ros_message != nullptr, "ROS message is nullpointer.");
  rcpputils::check_true(serialized_message != nullptr, "Serialized message is nullpointer.");
  detail::check(
    rmw_serialize(ros_message, type_support_, &serialized_message->get_rcl_serialized_message()),
    "Failed to serialize ROS message.");
}

void SerializationBase::deserialize_message(
  const SerializedMessage * serialized_message, void * ros_message) const
{
  rcpputils::check_true(serialized_message != nullptr, "Serialized message is nullpointer.");
  rcpputils::check_true(
    serialized_message->size() != 0, "Wrongly initialized. Serialized message has a size of zero.");
  rcpputils::check_true(ros_message != nullptr, "ROS message is nullpointer.");
  detail::check(
    rmw_deserialize(&serialized_message->get_rcl_serialized_message(), type_support_, ros_message),
    "Failed to deserialize serialized message.");
}

}  // namespace rclcpp
