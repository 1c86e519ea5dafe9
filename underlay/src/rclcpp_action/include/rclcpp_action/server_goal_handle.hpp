#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

#include "action_msgs/msg/goal_status.hpp"
#include "rcl_action/goal_handle.h"
#include "rclcpp/detail/check.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp_action/types.hpp"

namespace rclcpp_action
{

namespace detail
{

/// The state of a goal. It outlives the handle, as others may still ask for the result.
class GoalState
{
public:
  explicit GoalState(const rcl_action_goal_info_t & info)
  {
    rclcpp::detail::check(
      rcl_action_goal_handle_init(&handle_, &info, rcl_get_default_allocator()), "failed to track a goal");
  }
  RCLCPP_DISABLE_COPY(GoalState)
  ~GoalState()
  {
    if (rcl_action_goal_handle_fini(&handle_) != RCL_RET_OK) {
      rcl_reset_error();
    }
  }

  std::int8_t get() const
  {
    const std::lock_guard lock(mutex_);
    return read();
  }
  bool is_active() const
  {
    const std::lock_guard lock(mutex_);
    return rcl_action_goal_handle_is_active(&handle_);
  }
  bool is_cancelable() const
  {
    const std::lock_guard lock(mutex_);
    return rcl_action_goal_handle_is_cancelable(&handle_);
  }

  /// Throws RCLError when that cannot happen in this state.
  void update(rcl_action_goal_event_t event)
  {
    const std::lock_guard lock(mutex_);
    rclcpp::detail::check(rcl_action_update_goal_state(&handle_, event), "");
  }

  /// Ends it, unless it is over; whether it was not.
  bool try_canceling()
  {
    const std::lock_guard lock(mutex_);
    const bool was_active = rcl_action_goal_handle_is_active(&handle_);
    if (rcl_action_goal_handle_is_cancelable(&handle_)) {
      rclcpp::detail::check(rcl_action_update_goal_state(&handle_, GOAL_EVENT_CANCEL_GOAL), "");
    }
    if (was_active) {
      rclcpp::detail::check(rcl_action_update_goal_state(&handle_, GOAL_EVENT_CANCELED), "");
    }
    return was_active;
  }

private:
  std::int8_t read() const
  {
    rcl_action_goal_state_t state = GOAL_STATE_UNKNOWN;
    rclcpp::detail::check(
      rcl_action_goal_handle_get_status(&handle_, &state), "failed to get the status of a goal");
    return state;
  }

  mutable std::mutex mutex_;
  rcl_action_goal_handle_t handle_ = rcl_action_get_zero_initialized_goal_handle();
};

template<typename ActionT>
class ServerWork;

}  // namespace detail

/// What handles of all types have in common.
class ServerGoalHandleBase
{
public:
  RCLCPP_DISABLE_COPY(ServerGoalHandleBase)
  virtual ~ServerGoalHandleBase() = default;

  /// Whether a cancellation was accepted and the goal is not over yet.
  bool is_canceling() const {return state_->get() == GoalStatus::STATUS_CANCELING;}
  /// Whether it is not over.
  bool is_active() const {return state_->is_active();}
  bool is_executing() const {return state_->get() == GoalStatus::STATUS_EXECUTING;}

protected:
  explicit ServerGoalHandleBase(std::shared_ptr<detail::GoalState> state) : state_(std::move(state)) {}

  const std::shared_ptr<detail::GoalState> state_;
};

/// A goal that was accepted. One that is let go before it is over is canceled.
template<typename ActionT>
class ServerGoalHandle : public ServerGoalHandleBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(ServerGoalHandle)

  ~ServerGoalHandle() override
  {
    try {
      if (state_->try_canceling()) {
        tell_result(std::make_shared<typename ActionT::Result>());
      }
    } catch (const rclcpp::exceptions::RCLError &) {
      // The context has ended; nobody can be told any more.
    }
  }

  // These throw RCLError when the goal's state does not allow it: what is over stays as it is.
  void execute()
  {
    state_->update(GOAL_EVENT_EXECUTE);
    if (const auto work = work_.lock()) {
      work->publish_status();
    }
  }
  void succeed(typename ActionT::Result::SharedPtr result_msg)
  {
    end(GOAL_EVENT_SUCCEED, std::move(result_msg));
  }
  void abort(typename ActionT::Result::SharedPtr result_msg) {end(GOAL_EVENT_ABORT, std::move(result_msg));}
  /// Only when is_canceling().
  void canceled(typename ActionT::Result::SharedPtr result_msg)
  {
    end(GOAL_EVENT_CANCELED, std::move(result_msg));
  }

  void publish_feedback(typename std::shared_ptr<typename ActionT::Feedback> feedback_msg)
  {
    if (const auto work = work_.lock()) {
      work->publish_feedback(uuid_, *feedback_msg);
    }
  }

  const std::shared_ptr<const typename ActionT::Goal> get_goal() const {return goal_;}
  const GoalUUID & get_goal_id() const {return uuid_;}

private:
  friend class detail::ServerWork<ActionT>;

  ServerGoalHandle(
    std::shared_ptr<detail::GoalState> state, const GoalUUID & uuid,
    std::shared_ptr<const typename ActionT::Goal> goal, std::weak_ptr<detail::ServerWork<ActionT>> work)
  : ServerGoalHandleBase(std::move(state)), uuid_(uuid), goal_(std::move(goal)), work_(std::move(work))
  {
  }

  void end(rcl_action_goal_event_t event, typename ActionT::Result::SharedPtr result)
  {
    state_->update(event);
    tell_result(std::move(result));
  }

  void tell_result(typename ActionT::Result::SharedPtr result)
  {
    if (const auto work = work_.lock()) {
      work->finish(uuid_, *result);
    }
  }

  const GoalUUID uuid_;
  const std::shared_ptr<const typename ActionT::Goal> goal_;
  const std::weak_ptr<detail::ServerWork<ActionT>> work_;  // nothing is told once the server is gone
};

}  // namespace rclcpp_action
