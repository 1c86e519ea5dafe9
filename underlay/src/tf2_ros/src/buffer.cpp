#include "tf2_ros/buffer.h"

#include <chrono>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace tf2_ros
{

using geometry_msgs::msg::TransformStamped;
using tf2_msgs::srv::FrameGraph;
using namespace std::chrono_literals;

namespace
{

constexpr tf2::TransformableRequestHandle NEVER = 0xffffffffffffffffULL;

std::exception_ptr never(const std::string & target, const std::string & source)
{
  return std::make_exception_ptr(
    tf2::LookupException("Failed to transform from " + source + " to " + target));
}

}  // namespace

/// Somebody to be called.
struct Buffer::Waiting
{
  explicit Waiting(TransformReadyCallback given) : callback(std::move(given)), future(promise.get_future()) {}

  void end(const std::exception_ptr & error)
  {
    promise.set_exception(error);
    call();
  }
  void end(const Buffer & buffer, const std::string & target, const std::string & source, tf2::TimePoint time)
  {
    try {
      promise.set_value(buffer.lookupTransform(target, source, time));
    } catch (const tf2::TransformException &) {
      promise.set_exception(std::current_exception());
    }
    call();
  }

  const TransformReadyCallback callback;
  std::promise<TransformStamped> promise;
  TransformStampedFuture future;
  std::optional<TimerHandle> timer;

private:
  void call() const
  {
    if (callback) {
      callback(future);
    }
  }
};

struct Buffer::State
{
  rclcpp::Clock::SharedPtr clock;
  rclcpp::JumpHandler::SharedPtr jump_handler;
  rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logging;
  rclcpp::Service<FrameGraph>::SharedPtr frames_service;
  CreateTimerInterface::SharedPtr timers;

  std::mutex mutex;
  std::map<tf2::TransformableRequestHandle, std::shared_ptr<Waiting>> waiting;
};

Buffer::Buffer(rclcpp::Clock::SharedPtr clock, tf2::Duration cache_time, Made)
: BufferCore(cache_time), state_(std::make_unique<State>())
{
  if (!clock) {
    throw std::invalid_argument("clock must be a valid instance");
  }
  rcl_jump_threshold_t backwards{};
  backwards.on_clock_change = true;
  backwards.min_backward.nanoseconds = -1;
  state_->clock = std::move(clock);
  state_->jump_handler = state_->clock->create_jump_callback(
    nullptr, [this](const rcl_time_jump_t & jump) {
      const bool switched =
      jump.clock_change == RCL_ROS_TIME_ACTIVATED || jump.clock_change == RCL_ROS_TIME_DEACTIVATED;
      if (switched || jump.delta.nanoseconds < 0) {
        RCLCPP_WARN(
          logger(), "Detected %s. Clearing TF buffer.", switched ? "time source change" : "jump back in time");
        clear();
      }
    }, backwards);
}

Buffer::~Buffer()
{
  // Timers would call what is gone.
  std::map<tf2::TransformableRequestHandle, std::shared_ptr<Waiting>> left;
  {
    const std::lock_guard lock(state_->mutex);
    left = state_->waiting;
  }
  for (const auto & [handle, waiting] : left) {
    cancel(waiting->future);
  }
}

void Buffer::serve(
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base,
  rclcpp::node_interfaces::NodeServicesInterface::SharedPtr services,
  rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logging, const rclcpp::QoS & qos)
{
  state_->logging = std::move(logging);
  state_->frames_service = rclcpp::create_service<FrameGraph>(
    std::move(base), std::move(services), "tf2_frames",
    [this](FrameGraph::Request::SharedPtr, FrameGraph::Response::SharedPtr response) {
      response->frame_yaml = allFramesAsYAML();
    }, qos, nullptr);
}

rclcpp::Logger Buffer::logger() const
{
  return state_->logging ? state_->logging->get_logger() : rclcpp::get_logger("tf2_buffer");
}

/// Asks again and again; `error` tells why not.
template<typename AskT>
bool Buffer::wait_until(const AskT & ask, tf2::Duration timeout, std::string * error) const
{
  if (timeout != 0ns && !isUsingDedicatedThread()) {
    if (error) {
      *error = threading_error;
    }
    RCLCPP_ERROR(logger(), "%s", threading_error);
    return false;
  }
  const auto start = state_->clock->now();
  const auto waited = [this, start] {return fromRclcpp(state_->clock->now() - start);};
  bool possible = ask();
  // A recording that begins again takes the clock back.
  while (!possible && waited() < timeout && waited() >= -3s && rclcpp::ok()) {
    std::this_thread::sleep_for(10ms);
    possible = ask();
  }
  if (error) {
    std::ostringstream text;
    text << ". canTransform returned after " << tf2::durationToSec(waited()) << " timeout was " <<
      tf2::durationToSec(timeout) << ".";
    *error += text.str();
  }
  return possible;
}

TransformStamped Buffer::lookupTransform(
  const std::string & target_frame, const std::string & source_frame, const tf2::TimePoint & time,
  const tf2::Duration timeout) const
{
  std::string error;  // the lookup tells it, too
  canTransform(target_frame, source_frame, time, timeout, &error);
  return lookupTransform(target_frame, source_frame, time);
}

TransformStamped Buffer::lookupTransform(
  const std::string & target_frame, const tf2::TimePoint & target_time, const std::string & source_frame,
  const tf2::TimePoint & source_time, const std::string & fixed_frame, const tf2::Duration timeout) const
{
  std::string error;
  canTransform(target_frame, target_time, source_frame, source_time, fixed_frame, timeout, &error);
  return lookupTransform(target_frame, target_time, source_frame, source_time, fixed_frame);
}

bool Buffer::canTransform(
  const std::string & target_frame, const std::string & source_frame, const tf2::TimePoint & target_time,
  const tf2::Duration timeout, std::string * errstr) const
{
  const auto ask = [&] {return canTransform(target_frame, source_frame, target_time, errstr);};
  return wait_until(ask, timeout, errstr);
}

bool Buffer::canTransform(
  const std::string & target_frame, const tf2::TimePoint & target_time, const std::string & source_frame,
  const tf2::TimePoint & source_time, const std::string & fixed_frame, const tf2::Duration timeout,
  std::string * errstr) const
{
  const auto ask = [&] {
      return canTransform(target_frame, target_time, source_frame, source_time, fixed_frame, errstr);
    };
  return wait_until(ask, timeout, errstr);
}

TransformStampedFuture Buffer::waitForTransform(
  const std::string & target_frame, const std::string & source_frame, const tf2::TimePoint & time,
  const tf2::Duration & timeout, TransformReadyCallback callback)
{
  if (!state_->timers) {
    throw CreateTimerInterfaceException("timer interface not set before call to waitForTransform");
  }
  const auto waiting = std::make_shared<Waiting>(std::move(callback));
  const auto answer =
    [this](
    tf2::TransformableRequestHandle handle, const std::string & target, const std::string & source,
    tf2::TimePoint when, tf2::TransformableResult result) {
      const auto one = taken(handle);
      if (one && result == tf2::TransformAvailable) {
        one->end(*this, target, source, when);
      } else if (one) {
        one->end(never(target, source));
      }
    };
  {
    // An answer comes after this.
    const std::lock_guard lock(state_->mutex);
    const auto handle = addTransformableRequest(answer, target_frame, source_frame, time);
    waiting->future.setHandle(handle);
    if (handle != 0 && handle != NEVER) {
      waiting->timer = state_->timers->createTimer(
        state_->clock, timeout, [this, handle](const TimerHandle &) {
          if (const auto one = taken(handle)) {
            cancelTransformableRequest(handle);
            one->end(std::make_exception_ptr(tf2::TimeoutException("Timed out waiting for transform")));
          }
        });
      state_->waiting[handle] = waiting;
      return waiting->future;
    }
  }
  if (waiting->future.getHandle() == 0) {
    waiting->end(*this, target_frame, source_frame, time);
  } else {
    waiting->end(never(target_frame, source_frame));
  }
  return waiting->future;
}

/// Nobody else calls it then; null if somebody does.
std::shared_ptr<Buffer::Waiting> Buffer::taken(tf2::TransformableRequestHandle handle)
{
  std::shared_ptr<Waiting> one;
  {
    const std::lock_guard lock(state_->mutex);
    const auto found = state_->waiting.find(handle);
    if (found == state_->waiting.end()) {
      return nullptr;
    }
    one = found->second;
    state_->waiting.erase(found);
  }
  state_->timers->remove(*one->timer);
  return one;
}

void Buffer::cancel(const TransformStampedFuture & ts_future)
{
  cancelTransformableRequest(ts_future.getHandle());
  taken(ts_future.getHandle());
}

void Buffer::setCreateTimerInterface(CreateTimerInterface::SharedPtr create_timer_interface)
{
  state_->timers = std::move(create_timer_interface);
}

}  // namespace tf2_ros
