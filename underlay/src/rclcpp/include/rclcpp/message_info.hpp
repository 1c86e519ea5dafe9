#pragma once

#include "rmw/types.h"

namespace rclcpp
{

/// When a message was sent and received, and by whom it was sent.
class MessageInfo
{
public:
  MessageInfo() = default;
  MessageInfo(const rmw_message_info_t & rmw_message_info)  // NOLINT: it is one
  : rmw_message_info_(rmw_message_info) {}
  virtual ~MessageInfo() = default;

  const rmw_message_info_t & get_rmw_message_info() const {return rmw_message_info_;}
  rmw_message_info_t & get_rmw_message_info() {return rmw_message_info_;}

private:
  rmw_message_info_t rmw_message_info_{};
};

}  // namespace rclcpp
