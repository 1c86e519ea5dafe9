#pragma once

#include <chrono>
#include <string>

#include "builtin_interfaces/msg/duration.hpp"
#include "builtin_interfaces/msg/time.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/convert.h"
#include "tf2/exceptions.h"
#include "tf2/transform_datatypes.h"

namespace tf2_ros
{

// Between the times of tf2, of messages and of rclcpp. The kind of clock is not known to tf2.

inline tf2::TimePoint fromRclcpp(const rclcpp::Time & time)
{
  return tf2::TimePoint(std::chrono::nanoseconds(time.nanoseconds()));
}

inline rclcpp::Time toRclcpp(const tf2::TimePoint & time)
{
  return rclcpp::Time(time.time_since_epoch().count());
}

inline tf2::Duration fromRclcpp(const rclcpp::Duration & duration)
{
  return tf2::Duration(duration.nanoseconds());
}

inline rclcpp::Duration toRclcpp(const tf2::Duration & duration) {return rclcpp::Duration(duration);}

inline builtin_interfaces::msg::Time toMsg(const tf2::TimePoint & t) {return toRclcpp(t);}
inline builtin_interfaces::msg::Duration toMsg(const tf2::Duration & t) {return toRclcpp(t);}

inline tf2::TimePoint fromMsg(const builtin_interfaces::msg::Time & time_msg)
{
  return tf2::TimePoint(std::chrono::seconds(time_msg.sec) + std::chrono::nanoseconds(time_msg.nanosec));
}

inline tf2::Duration fromMsg(const builtin_interfaces::msg::Duration & duration_msg)
{
  return std::chrono::seconds(duration_msg.sec) + std::chrono::nanoseconds(duration_msg.nanosec);
}

inline double timeToSec(const builtin_interfaces::msg::Time & time_msg)
{
  return time_msg.sec + 1e-9 * time_msg.nanosec;
}

/// What can be asked about frames by those who may wait: see tf2::BufferCore.
class BufferInterface
{
public:
  virtual ~BufferInterface() = default;

  virtual geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const std::string & source_frame, const tf2::TimePoint & time,
    const tf2::Duration timeout) const = 0;
  virtual geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const tf2::TimePoint & target_time, const std::string & source_frame,
    const tf2::TimePoint & source_time, const std::string & fixed_frame,
    const tf2::Duration timeout) const = 0;
  virtual bool canTransform(
    const std::string & target_frame, const std::string & source_frame, const tf2::TimePoint & time,
    const tf2::Duration timeout, std::string * errstr = nullptr) const = 0;
  virtual bool canTransform(
    const std::string & target_frame, const tf2::TimePoint & target_time, const std::string & source_frame,
    const tf2::TimePoint & source_time, const std::string & fixed_frame, const tf2::Duration timeout,
    std::string * errstr = nullptr) const = 0;

  /// `in`, which has a frame and a time, as it is in the target frame.
  template<class T>
  T & transform(
    const T & in, T & out, const std::string & target_frame,
    tf2::Duration timeout = tf2::Duration::zero()) const
  {
    tf2::doTransform(
      in, out, lookupTransform(target_frame, tf2::getFrameId(in), tf2::getTimestamp(in), timeout));
    return out;
  }

  template<class T>
  T transform(
    const T & in, const std::string & target_frame, tf2::Duration timeout = tf2::Duration::zero()) const
  {
    T out;
    transform(in, out, target_frame, timeout);
    return out;
  }

  /// The same, as another type.
  template<class A, class B>
  B & transform(
    const A & in, B & out, const std::string & target_frame,
    tf2::Duration timeout = tf2::Duration::zero()) const
  {
    tf2::convert(transform(in, target_frame, timeout), out);
    return out;
  }

  // The same, at another time; the fixed frame is what does not move in between.

  template<class T>
  T & transform(
    const T & in, T & out, const std::string & target_frame, const tf2::TimePoint & target_time,
    const std::string & fixed_frame, tf2::Duration timeout = tf2::Duration::zero()) const
  {
    tf2::doTransform(
      in, out, lookupTransform(
        target_frame, target_time, tf2::getFrameId(in), tf2::getTimestamp(in), fixed_frame, timeout));
    return out;
  }

  template<class T>
  T transform(
    const T & in, const std::string & target_frame, const tf2::TimePoint & target_time,
    const std::string & fixed_frame, tf2::Duration timeout = tf2::Duration::zero()) const
  {
    T out;
    transform(in, out, target_frame, target_time, fixed_frame, timeout);
    return out;
  }

  template<class A, class B>
  B & transform(
    const A & in, B & out, const std::string & target_frame, const tf2::TimePoint & target_time,
    const std::string & fixed_frame, tf2::Duration timeout = tf2::Duration::zero()) const
  {
    tf2::convert(transform(in, target_frame, target_time, fixed_frame, timeout), out);
    return out;
  }
};

}  // namespace tf2_ros
