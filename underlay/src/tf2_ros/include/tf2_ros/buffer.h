#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/node_interfaces/getters.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/buffer_core.h"
#include "tf2/time.h"
#include "tf2_msgs/srv/frame_graph.hpp"
#include "tf2_ros/async_buffer_interface.h"
#include "tf2_ros/buffer_interface.h"
#include "tf2_ros/create_timer_interface.h"

namespace tf2_ros
{

static const char threading_error[] =
  "Do not call canTransform or lookupTransform with a timeout unless you are using another thread for "
  "populating data. Without a dedicated thread it will always timeout.  If you have a separate thread "
  "servicing tf messages, call setUsingDedicatedThread(true) on your Buffer instance.";

/// Where frames were during the last seconds; who asks may wait. A TransformListener fills it.
class Buffer : public BufferInterface, public AsyncBufferInterface, public tf2::BufferCore
{
public:
  using SharedPtr = std::shared_ptr<Buffer>;
  using tf2::BufferCore::canTransform;
  using tf2::BufferCore::lookupTransform;

  /// It is cleared when the clock jumps back. With a node, that offers the service `tf2_frames`.
  /// Throws std::invalid_argument if there is no clock.
  template<typename NodeT = rclcpp::Node::SharedPtr>
  Buffer(  // NOLINT: as the real one has it
    rclcpp::Clock::SharedPtr clock, tf2::Duration cache_time = tf2::BUFFER_CORE_DEFAULT_CACHE_TIME,
    NodeT && node = NodeT(), const rclcpp::QoS & qos = rclcpp::ServicesQoS())
  : Buffer(std::move(clock), cache_time, Made())
  {
    if (node) {
      serve(
        rclcpp::node_interfaces::get_node_base_interface(node),
        rclcpp::node_interfaces::get_node_services_interface(node),
        rclcpp::node_interfaces::get_node_logging_interface(node), qos);
    }
  }
  ~Buffer() override;

  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const std::string & source_frame, const tf2::TimePoint & time,
    const tf2::Duration timeout) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const tf2::TimePoint & target_time, const std::string & source_frame,
    const tf2::TimePoint & source_time, const std::string & fixed_frame,
    const tf2::Duration timeout) const override;
  bool canTransform(
    const std::string & target_frame, const std::string & source_frame, const tf2::TimePoint & target_time,
    const tf2::Duration timeout, std::string * errstr = nullptr) const override;
  bool canTransform(
    const std::string & target_frame, const tf2::TimePoint & target_time, const std::string & source_frame,
    const tf2::TimePoint & source_time, const std::string & fixed_frame, const tf2::Duration timeout,
    std::string * errstr = nullptr) const override;

  // The same, with the times of rclcpp.

  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const std::string & source_frame, const rclcpp::Time & time,
    const rclcpp::Duration timeout = rclcpp::Duration::from_nanoseconds(0)) const
  {
    return lookupTransform(target_frame, source_frame, fromRclcpp(time), fromRclcpp(timeout));
  }
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const rclcpp::Time & target_time, const std::string & source_frame,
    const rclcpp::Time & source_time, const std::string & fixed_frame,
    const rclcpp::Duration timeout = rclcpp::Duration::from_nanoseconds(0)) const
  {
    return lookupTransform(
      target_frame, fromRclcpp(target_time), source_frame, fromRclcpp(source_time), fixed_frame,
      fromRclcpp(timeout));
  }
  bool canTransform(
    const std::string & target_frame, const std::string & source_frame, const rclcpp::Time & time,
    const rclcpp::Duration timeout = rclcpp::Duration::from_nanoseconds(0),
    std::string * errstr = nullptr) const
  {
    return canTransform(target_frame, source_frame, fromRclcpp(time), fromRclcpp(timeout), errstr);
  }
  bool canTransform(
    const std::string & target_frame, const rclcpp::Time & target_time, const std::string & source_frame,
    const rclcpp::Time & source_time, const std::string & fixed_frame,
    const rclcpp::Duration timeout = rclcpp::Duration::from_nanoseconds(0),
    std::string * errstr = nullptr) const
  {
    return canTransform(
      target_frame, fromRclcpp(target_time), source_frame, fromRclcpp(source_time), fixed_frame,
      fromRclcpp(timeout), errstr);
  }

  /// Calls once, as soon as it is known, or never will be, or the time is over: LookupException or
  /// TimeoutException. Throws CreateTimerInterfaceException unless there are timers.
  TransformStampedFuture waitForTransform(
    const std::string & target_frame, const std::string & source_frame, const tf2::TimePoint & time,
    const tf2::Duration & timeout, TransformReadyCallback callback) override;
  TransformStampedFuture waitForTransform(
    const std::string & target_frame, const std::string & source_frame, const rclcpp::Time & time,
    const rclcpp::Duration & timeout, TransformReadyCallback callback)
  {
    return waitForTransform(
      target_frame, source_frame, fromRclcpp(time), fromRclcpp(timeout), std::move(callback));
  }
  /// Nobody is called then, and the future is a broken promise.
  void cancel(const TransformStampedFuture & ts_future) override;

  void setCreateTimerInterface(CreateTimerInterface::SharedPtr create_timer_interface);

private:
  struct Made {};
  struct Waiting;
  struct State;

  Buffer(rclcpp::Clock::SharedPtr clock, tf2::Duration cache_time, Made);
  void serve(
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base,
    rclcpp::node_interfaces::NodeServicesInterface::SharedPtr services,
    rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logging, const rclcpp::QoS & qos);
  rclcpp::Logger logger() const;
  template<typename AskT>
  bool wait_until(const AskT & ask, tf2::Duration timeout, std::string * error) const;
  std::shared_ptr<Waiting> taken(tf2::TransformableRequestHandle handle);

  std::unique_ptr<State> state_;
};

}  // namespace tf2_ros
