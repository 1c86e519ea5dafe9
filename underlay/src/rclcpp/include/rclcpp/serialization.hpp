#pragma once

#include "rclcpp/serialized_message.hpp"
#include "rosidl_runtime_c/message_type_support_struct.h"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace rclcpp
{

/// Makes bytes of messages of one type, and messages of bytes.
class SerializationBase
{
public:
  explicit SerializationBase(const rosidl_message_type_support_t * type_support);
  virtual ~SerializationBase() = default;

  /// These throw rcpputils::IllegalStateException for null pointers and for no bytes, and RCLError when the
  /// bytes are not of such a message.
  void serialize_message(const void * ros_message, SerializedMessage * serialized_message) const;
  void deserialize_message(const SerializedMessage * serialized_message, void * ros_message) const;

private:
  const rosidl_message_type_support_t * type_support_;
};

template<typename MessageT>
class Serialization : public SerializationBase
{
public:
  Serialization()
  : SerializationBase(rosidl_typesupport_cpp::get_message_type_support_handle<MessageT>()) {}
};

}  // namespace rclcpp
