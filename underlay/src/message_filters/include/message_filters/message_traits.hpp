#pragma once

#include <string>
#include <type_traits>

#include "rclcpp/time.hpp"
#include "std_msgs/msg/header.hpp"

namespace message_filters::message_traits
{

template<typename M, typename = void>
struct HasHeader : std::false_type {};
template<typename M>
struct HasHeader<M, std::enable_if_t<std::is_same_v<std_msgs::msg::Header, decltype(M().header)>>>
: std::true_type {};

/// The frame of a message. Messages without a header need a specialization.
template<typename M, typename Enable = void>
struct FrameId {};
template<typename M>
struct FrameId<M, std::enable_if_t<HasHeader<M>::value>>
{
  static std::string * pointer(M & message) {return &message.header.frame_id;}
  static const std::string * pointer(const M & message) {return &message.header.frame_id;}
  static std::string value(const M & message) {return message.header.frame_id;}
};

/// The time of a message. That of messages without a header is 0, unless there is a specialization.
template<typename M, typename Enable = void>
struct TimeStamp
{
  static rclcpp::Time value(const M &) {return rclcpp::Time();}
};
template<typename M>
struct TimeStamp<M, std::enable_if_t<HasHeader<M>::value>>
{
  static rclcpp::Time value(const M & message) {return rclcpp::Time(message.header.stamp, RCL_ROS_TIME);}
};

}  // namespace message_filters::message_traits
