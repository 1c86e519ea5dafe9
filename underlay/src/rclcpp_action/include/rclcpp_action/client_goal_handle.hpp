#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <utility>

#include "rclcpp/macros.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp_action/exceptions.hpp"
#include "rclcpp_action/types.hpp"

namespace rclcpp_action
{

/// How a goal ended.
enum class ResultCode : std::int8_t
{
  UNKNOWN = GoalStatus::STATUS_UNKNOWN,
  SUCCEEDED = GoalStatus::STATUS_SUCCEEDED,
  CANCELED = GoalStatus::STATUS_CANCELED,
  ABORTED = GoalStatus::STATUS_ABORTED,
};

template<typename ActionT>
class Client;

/// A goal that a server accepted, as its client sees it.
template<typename ActionT>
class ClientGoalHandle
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(ClientGoalHandle)
  RCLCPP_DISABLE_COPY(ClientGoalHandle)

  struct WrappedResult
  {
    GoalUUID goal_id;
    ResultCode code;
    typename ActionT::Result::SharedPtr result;
  };

  using Feedback = typename ActionT::Feedback;
  using Result = typename ActionT::Result;
  using FeedbackCallback = std::function<void(
        typename ClientGoalHandle<ActionT>::SharedPtr, const std::shared_ptr<const Feedback>)>;
  using ResultCallback = std::function<void(const WrappedResult &)>;

  const GoalUUID & get_goal_id() const {return info_.goal_id.uuid;}
  rclcpp::Time get_goal_stamp() const {return info_.stamp;}

  /// The last status that was heard, one of action_msgs::msg::GoalStatus.
  std::int8_t get_status()
  {
    const std::lock_guard lock(mutex_);
    return status_;
  }
  bool is_feedback_aware()
  {
    const std::lock_guard lock(mutex_);
    return static_cast<bool>(feedback_callback_);
  }
  bool is_result_aware()
  {
    const std::lock_guard lock(mutex_);
    return is_result_aware_;
  }

private:
  friend class Client<ActionT>;

  ClientGoalHandle(const GoalInfo & info, FeedbackCallback feedback_callback, ResultCallback result_callback)
  : info_(info), future_(promise_.get_future()), feedback_callback_(std::move(feedback_callback)),
    result_callback_(std::move(result_callback))
  {
  }

  bool is_over() const {return future_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;}

  void set_status(std::int8_t status)
  {
    const std::lock_guard lock(mutex_);
    if (!is_over()) {  // a status that was on its way does not undo the result
      status_ = status;
    }
  }

  void set_result(const WrappedResult & result)
  {
    std::unique_lock lock(mutex_);
    if (is_over()) {
      return;
    }
    status_ = static_cast<std::int8_t>(result.code);
    promise_.set_value(result);
    const auto callback = result_callback_;
    lock.unlock();
    if (callback) {
      callback(result);
    }
  }

  /// Nobody will bring the result any more.
  void invalidate()
  {
    const std::lock_guard lock(mutex_);
    if (!is_over()) {
      is_result_aware_ = false;
      status_ = GoalStatus::STATUS_UNKNOWN;
      promise_.set_exception(std::make_exception_ptr(exceptions::UnawareGoalHandleError()));
    }
  }

  FeedbackCallback feedback_callback()
  {
    const std::lock_guard lock(mutex_);
    return feedback_callback_;
  }

  void set_result_callback(ResultCallback callback)
  {
    const std::lock_guard lock(mutex_);
    result_callback_ = std::move(callback);
  }

  void stop_callbacks()
  {
    const std::lock_guard lock(mutex_);
    feedback_callback_ = nullptr;
    result_callback_ = nullptr;
  }

  /// Whether it was aware of its result before.
  bool become_result_aware()
  {
    const std::lock_guard lock(mutex_);
    return std::exchange(is_result_aware_, true);
  }

  const GoalInfo info_;
  std::mutex mutex_;
  std::promise<WrappedResult> promise_;
  const std::shared_future<WrappedResult> future_;
  FeedbackCallback feedback_callback_;
  ResultCallback result_callback_;
  bool is_result_aware_ = false;
  std::int8_t status_ = GoalStatus::STATUS_ACCEPTED;
};

}  // namespace rclcpp_action
