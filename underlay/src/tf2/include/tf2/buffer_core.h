#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "tf2/LinearMath/Transform.h"
#include "tf2/buffer_core_interface.h"
#include "tf2/exceptions.h"
#include "tf2/time.h"

namespace tf2
{

using TransformableRequestHandle = std::uint64_t;

enum TransformableResult
{
  TransformAvailable,
  TransformFailure,
};

static constexpr Duration BUFFER_CORE_DEFAULT_CACHE_TIME = std::chrono::seconds(10);

/// Where frames were during the last seconds. Any number of threads may use it.
class BufferCore : public BufferCoreInterface
{
public:
  /// Deeper trees have a loop.
  static constexpr std::uint32_t MAX_GRAPH_DEPTH = 1000;

  explicit BufferCore(Duration cache_time = BUFFER_CORE_DEFAULT_CACHE_TIME);
  ~BufferCore() override;

  /// Forgets all but static frames and names.
  void clear() override;

  /// False, and a message is logged, if it makes no sense or is older than what is kept.
  bool setTransform(
    const geometry_msgs::msg::TransformStamped & transform, const std::string & authority,
    bool is_static = false);

  /// What leads from coordinates in the source frame to those in the target frame.
  /// The time may be TimePointZero: the latest for which the answer is known.
  /// Throws LookupException, ConnectivityException, ExtrapolationException, InvalidArgumentException.
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const std::string & source_frame,
    const TimePoint & time) const override;

  /// The same, from one time to another; the fixed frame is what does not move in between.
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const TimePoint & target_time, const std::string & source_frame,
    const TimePoint & source_time, const std::string & fixed_frame) const override;

  /// Whether the lookup would succeed; `error_msg` tells why not.
  bool canTransform(
    const std::string & target_frame, const std::string & source_frame, const TimePoint & time,
    std::string * error_msg = nullptr) const override;
  bool canTransform(
    const std::string & target_frame, const TimePoint & target_time, const std::string & source_frame,
    const TimePoint & source_time, const std::string & fixed_frame,
    std::string * error_msg = nullptr) const override;

  std::vector<std::string> getAllFrameNames() const override;
  std::string allFramesAsYAML(TimePoint current_time) const;
  std::string allFramesAsYAML() const;
  std::string allFramesAsString() const;

  using TransformableCallback = std::function<void (
        TransformableRequestHandle request_handle, const std::string & target_frame,
        const std::string & source_frame, TimePoint time, TransformableResult result)>;

  /// Calls once, as soon as the lookup would succeed. 0 if it would already, the highest number if it never will.
  TransformableRequestHandle addTransformableRequest(
    const TransformableCallback & cb, const std::string & target_frame, const std::string & source_frame,
    TimePoint time);
  void cancelTransformableRequest(TransformableRequestHandle handle);

  /// Whether a thread of its own fills it, so that others may wait.
  void setUsingDedicatedThread(bool value);
  bool isUsingDedicatedThread() const;

  Duration getCacheLength() const;

  bool _frameExists(const std::string & frame_id_str) const;
  /// False if that is not known for the time.
  bool _getParent(const std::string & frame_id, TimePoint time, std::string & parent) const;
  void _getFrameStrings(std::vector<std::string> & ids) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tf2
