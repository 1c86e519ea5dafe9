#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <ratio>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "message_filters/connection.hpp"
#include "message_filters/message_traits.hpp"
#include "message_filters/simple_filter.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/buffer_core_interface.h"
#include "tf2_ros/async_buffer_interface.h"
#include "tf2_ros/buffer.h"

namespace tf2_ros
{

namespace filter_failure_reasons
{

/// Why a message was dropped.
enum FilterFailureReason
{
  Unknown,
  /// The transform never became known, or the message is older than everything in the buffer.
  OutTheBack,
  EmptyFrameID,
  /// Was known for a moment, but no longer is.
  NoTransformFound,
  QueueFull,
  FilterFailureReasonCount,
};

}  // namespace filter_failure_reasons

using FilterFailureReason = filter_failure_reasons::FilterFailureReason;

inline std::string get_filter_failure_reason_string(FilterFailureReason reason)
{
  switch (reason) {
    case filter_failure_reasons::OutTheBack:
      return "the transform at its time did not become known, or is no longer kept";
    case filter_failure_reasons::EmptyFrameID:
      return "its frame is empty";
    case filter_failure_reasons::NoTransformFound:
      return "the transform at its time is no longer known";
    case filter_failure_reasons::QueueFull:
      return "the queue is full";
    default:
      return "the reason is not known";
  }
}

class MessageFilterBase
{
public:
  using V_string = std::vector<std::string>;

  virtual ~MessageFilterBase() = default;
  /// Forgets all messages that wait.
  virtual void clear() = 0;
  virtual void setTargetFrame(const std::string & target_frame) = 0;
  /// Messages wait until all of these frames are known.
  virtual void setTargetFrames(const V_string & target_frames) = 0;
  /// The frames must also be known this much later than the time of a message.
  virtual void setTolerance(const rclcpp::Duration & tolerance) = 0;
};

/// Keeps messages until they can be transformed into a frame, then passes them on.
template<class M, class BufferT = tf2_ros::Buffer>
class MessageFilter : public MessageFilterBase, public message_filters::SimpleFilter<M>
{
  static_assert(std::is_base_of_v<tf2::BufferCoreInterface, BufferT>);
  static_assert(std::is_base_of_v<tf2_ros::AsyncBufferInterface, BufferT>);

public:
  using MConstPtr = std::shared_ptr<M const>;
  using MEvent = message_filters::MessageEvent<M const>;

  // If there are more than `queue_size` messages, the oldest is dropped; 0 stands for any number. A message is
  // dropped after `buffer_timeout`, too.

  template<typename TimeRepT = std::int64_t, typename TimeT = std::nano>
  MessageFilter(
    BufferT & buffer, const std::string & target_frame, std::uint32_t queue_size,
    const rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr & node_logging,
    const rclcpp::node_interfaces::NodeClockInterface::SharedPtr & node_clock,
    std::chrono::duration<TimeRepT, TimeT> buffer_timeout = std::chrono::duration<TimeRepT, TimeT>::max())
  : logging_(node_logging), clock_(node_clock), buffer_(buffer), timeout_(buffer_timeout),
    queue_size_(queue_size)
  {
    setTargetFrame(target_frame);
  }
  template<typename TimeRepT = std::int64_t, typename TimeT = std::nano>
  MessageFilter(
    BufferT & buffer, const std::string & target_frame, std::uint32_t queue_size,
    const rclcpp::Node::SharedPtr & node,
    std::chrono::duration<TimeRepT, TimeT> buffer_timeout = std::chrono::duration<TimeRepT, TimeT>::max())
  : MessageFilter(
      buffer, target_frame, queue_size, node->get_node_logging_interface(),
      node->get_node_clock_interface(), buffer_timeout)
  {
  }
  template<class F, typename TimeRepT = std::int64_t, typename TimeT = std::nano>
  MessageFilter(
    F & input, BufferT & buffer, const std::string & target_frame, std::uint32_t queue_size,
    const rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr & node_logging,
    const rclcpp::node_interfaces::NodeClockInterface::SharedPtr & node_clock,
    std::chrono::duration<TimeRepT, TimeT> buffer_timeout = std::chrono::duration<TimeRepT, TimeT>::max())
  : MessageFilter(buffer, target_frame, queue_size, node_logging, node_clock, buffer_timeout)
  {
    connectInput(input);
  }
  template<class F, typename TimeRepT = std::int64_t, typename TimeT = std::nano>
  MessageFilter(
    F & input, BufferT & buffer, const std::string & target_frame, std::uint32_t queue_size,
    const rclcpp::Node::SharedPtr & node,
    std::chrono::duration<TimeRepT, TimeT> buffer_timeout = std::chrono::duration<TimeRepT, TimeT>::max())
  : MessageFilter(
      input, buffer, target_frame, queue_size, node->get_node_logging_interface(),
      node->get_node_clock_interface(), buffer_timeout)
  {
  }
  ~MessageFilter() override
  {
    input_.disconnect();
    {
      const std::lock_guard lock(gate_->mutex);
      gate_->is_open = false;
    }
    clear();
  }

  template<class F>
  void connectInput(F & input)
  {
    input_.disconnect();
    input_ = input.registerCallback(
      std::function<void(const MEvent &)>([this](const MEvent & event) {add(event);}));
  }

  void setTargetFrame(const std::string & target_frame) override {setTargetFrames({target_frame});}
  void setTargetFrames(const V_string & target_frames) override
  {
    const std::lock_guard lock(mutex_);
    targets_.clear();
    std::transform(target_frames.begin(), target_frames.end(), std::back_inserter(targets_), without_slash);
  }
  /// Each with a space after it.
  std::string getTargetFramesString()
  {
    const std::lock_guard lock(mutex_);
    std::string text;
    for (const auto & target : targets_) {
      text += target + " ";
    }
    return text;
  }
  void setTolerance(const rclcpp::Duration & tolerance) override
  {
    const std::lock_guard lock(mutex_);
    tolerance_ = tolerance;
  }
  virtual void setQueueSize(std::uint32_t new_queue_size)
  {
    const std::lock_guard lock(mutex_);
    queue_size_ = new_queue_size;
  }
  virtual std::uint32_t getQueueSize()
  {
    const std::lock_guard lock(mutex_);
    return queue_size_;
  }

  void clear() override
  {
    std::map<std::uint64_t, Waiting> gone;
    {
      const std::lock_guard lock(mutex_);
      gone.swap(waiting_);
    }
    for (const auto & [number, one] : gone) {
      cancel(one);
    }
  }

  void add(const MConstPtr & message) {add(MEvent(message, clock_->get_clock()->now()));}
  /// If it can be transformed already, callbacks are called before this returns.
  void add(const MEvent & event)
  {
    const auto requests = requests_for(event);
    if (requests.empty()) {
      return;
    }
    if (requests.front().source.empty()) {
      drop(event, filter_failure_reasons::EmptyFrameID);
      return;
    }
    std::optional<Waiting> oldest;
    std::uint64_t number;
    {
      const std::lock_guard lock(mutex_);
      if (queue_size_ != 0 && waiting_.size() >= queue_size_) {
        oldest = std::move(waiting_.begin()->second);
        waiting_.erase(waiting_.begin());
      }
      number = next_++;
      waiting_[number] = Waiting{event, {}, requests.size(), false};
    }
    if (oldest) {
      cancel(*oldest);
      drop(oldest->event, filter_failure_reasons::QueueFull);
    }
    for (const auto & [target, source, time] : requests) {
      ask(number, target, source, time);
    }
  }

private:
  struct Request
  {
    std::string target;
    std::string source;
    tf2::TimePoint time;
  };
  struct Waiting
  {
    MEvent event;
    std::vector<TransformStampedFuture> futures;
    std::size_t missing;
    bool has_failed;
  };
  /// Answers of the buffer that come during the filter's end wait for it here, and then do nothing.
  struct Gate
  {
    std::recursive_mutex mutex;
    bool is_open = true;
  };

  static std::string without_slash(const std::string & frame)
  {
    return frame.substr(!frame.empty() && frame.front() == '/' ? 1 : 0);
  }

  std::vector<Request> requests_for(const MEvent & event)
  {
    const auto & message = *event.getConstMessage();
    const auto source = without_slash(message_filters::message_traits::FrameId<M>::value(message));
    const rclcpp::Time time = message_filters::message_traits::TimeStamp<M>::value(message);
    const std::lock_guard lock(mutex_);
    std::vector<Request> requests;
    for (const auto & target : targets_) {
      requests.push_back({target, source, fromRclcpp(time)});
      if (tolerance_.nanoseconds() != 0) {
        requests.push_back({target, source, fromRclcpp(time + tolerance_)});
      }
    }
    return requests;
  }

  void ask(
    std::uint64_t number, const std::string & target, const std::string & source, tf2::TimePoint time)
  {
    const auto future = buffer_.waitForTransform(
      target, source, time, timeout_,
      [this, number, gate = gate_](const TransformStampedFuture & answer) {
        const std::lock_guard lock(gate->mutex);
        if (gate->is_open) {
          answered(number, answer);
        }
      });
    const std::lock_guard lock(mutex_);
    if (const auto found = waiting_.find(number); found != waiting_.end()) {
      found->second.futures.push_back(future);
    }
  }

  void answered(std::uint64_t number, const TransformStampedFuture & answer)
  {
    std::optional<Waiting> done;
    {
      const std::lock_guard lock(mutex_);
      const auto found = waiting_.find(number);
      if (found == waiting_.end()) {
        return;
      }
      found->second.has_failed |= !has_value(answer);
      if (--found->second.missing != 0) {
        return;
      }
      done = std::move(found->second);
      waiting_.erase(found);
    }
    if (done->has_failed) {
      drop(done->event, filter_failure_reasons::OutTheBack);
    } else if (!can_transform(done->event)) {
      drop(done->event, filter_failure_reasons::NoTransformFound);
    } else {
      this->signalMessage(done->event);
    }
  }

  static bool has_value(const TransformStampedFuture & answer)
  {
    try {
      answer.get();
      return true;
    } catch (const std::exception &) {
      return false;
    }
  }

  bool can_transform(const MEvent & event)
  {
    const auto requests = requests_for(event);
    return std::all_of(
      requests.begin(), requests.end(), [this](const Request & one) {
        return buffer_.canTransform(one.target, one.source, one.time, nullptr);
      });
  }

  void cancel(const Waiting & one)
  {
    for (const auto & future : one.futures) {
      buffer_.cancel(future);
    }
  }

  void drop(const MEvent & event, FilterFailureReason reason)
  {
    const auto & message = *event.getConstMessage();
    RCLCPP_INFO(
      logging_->get_logger(), "Dropped a message in the frame '%s' at time %.3f: %s",
      message_filters::message_traits::FrameId<M>::value(message).c_str(),
      message_filters::message_traits::TimeStamp<M>::value(message).seconds(),
      get_filter_failure_reason_string(reason).c_str());
  }

  const rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logging_;
  const rclcpp::node_interfaces::NodeClockInterface::SharedPtr clock_;
  BufferT & buffer_;
  const tf2::Duration timeout_;
  const std::shared_ptr<Gate> gate_ = std::make_shared<Gate>();
  message_filters::Connection input_;

  /// Guards what follows. No function of others is called under it.
  std::mutex mutex_;
  V_string targets_;
  rclcpp::Duration tolerance_{0, 0};
  std::uint32_t queue_size_;
  std::uint64_t next_ = 0;
  /// By their order.
  std::map<std::uint64_t, Waiting> waiting_;
};

}  // namespace tf2_ros
