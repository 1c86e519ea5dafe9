#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rcl_action/action_server.h"
#include "rclcpp/clock.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp_action/detail/names.hpp"
#include "rclcpp_action/server_goal_handle.hpp"
#include "rclcpp_action/types.hpp"

namespace rclcpp_action
{

/// What becomes of a goal.
enum class GoalResponse : std::int8_t
{
  REJECT = 1,
  ACCEPT_AND_EXECUTE = 2,
  /// Somebody calls execute() of its handle later.
  ACCEPT_AND_DEFER = 3,
};

enum class CancelResponse : std::int8_t
{
  REJECT = 1,
  ACCEPT = 2,
};

namespace detail
{

/// The goals of a server and what is done about them. Several threads may be in it; no lock is held while
/// the program's callbacks run. Goal handles and services refer to it weakly.
template<typename ActionT>
class ServerWork : public std::enable_shared_from_this<ServerWork<ActionT>>
{
public:
  using Handle = ServerGoalHandle<ActionT>;
  using GoalCallback =
    std::function<GoalResponse(const GoalUUID &, std::shared_ptr<const typename ActionT::Goal>)>;
  using CancelCallback = std::function<rclcpp_action::CancelResponse(std::shared_ptr<Handle>)>;
  using AcceptedCallback = std::function<void(std::shared_ptr<Handle>)>;

  ServerWork(
    const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr & node, rclcpp::Clock::SharedPtr clock,
    const std::string & name, const rcl_action_server_options_t & options, GoalCallback handle_goal,
    CancelCallback handle_cancel, AcceptedCallback handle_accepted)
  : clock_(std::move(clock)), result_timeout_(options.result_timeout.nanoseconds),
    handle_goal_(std::move(handle_goal)), handle_cancel_(std::move(handle_cancel)),
    handle_accepted_(std::move(handle_accepted)),
    feedback_(
      std::make_shared<rclcpp::Publisher<FeedbackMessage>>(
        node, part_of(name, "feedback"), qos_of(options.feedback_topic_qos), rclcpp::PublisherOptions())),
    status_(
      std::make_shared<rclcpp::Publisher<StatusMessage>>(
        node, part_of(name, "status"), qos_of(options.status_topic_qos), rclcpp::PublisherOptions()))
  {
  }

  /// Begins to hear clients.
  void serve(
    const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & name,
    const rcl_action_server_options_t & options, const rclcpp::CallbackGroup::SharedPtr & group)
  {
    // The result service first: it is there whenever a goal can be sent.
    result_ = add<GetResult>(
      node, part_of(name, "get_result"), options.result_service_qos, group, &ServerWork::take_result);
    cancel_ = add<CancelGoal>(
      node, part_of(name, "cancel_goal"), options.cancel_service_qos, group, &ServerWork::take_cancel);
    goal_ = add<SendGoal>(
      node, part_of(name, "send_goal"), options.goal_service_qos, group, &ServerWork::take_goal);
  }

  void publish_feedback(const GoalUUID & id, const typename ActionT::Feedback & feedback)
  {
    FeedbackMessage message;
    message.goal_id.uuid = id;
    message.feedback = feedback;
    feedback_->publish(message);
  }

  void publish_status()
  {
    const std::lock_guard lock(mutex_);  // also while it is published, so that no older one comes later
    drop_old_results();
    StatusMessage message;
    for (const auto & entry : entries_) {
      action_msgs::msg::GoalStatus status;
      status.goal_info = entry.info;
      status.status = entry.state->get();
      message.status_list.push_back(status);
    }
    status_->publish(message);
  }

  /// Keeps the result of a goal that is over, and sends it to those who wait for it.
  void finish(const GoalUUID & id, const typename ActionT::Result & result)
  {
    std::vector<rmw_request_id_t> waiting;
    ResultResponse response;
    response.result = result;
    {
      const std::lock_guard lock(mutex_);
      const auto entry = find(id);
      if (entry == entries_.end()) {
        return;
      }
      response.status = entry->state->get();
      entry->result = response;
      entry->over = clock_->now();
      waiting.swap(entry->waiting);
    }
    publish_status();
    for (auto & header : waiting) {
      result_->send_response(header, response);
    }
  }

private:
  using SendGoal = typename ActionT::Impl::SendGoalService;
  using CancelGoal = typename ActionT::Impl::CancelGoalService;
  using GetResult = typename ActionT::Impl::GetResultService;
  using ResultResponse = typename GetResult::Response;
  using FeedbackMessage = typename ActionT::Impl::FeedbackMessage;
  using StatusMessage = typename ActionT::Impl::GoalStatusMessage;

  struct Entry
  {
    GoalInfo info;
    std::shared_ptr<GoalState> state;
    std::weak_ptr<Handle> handle;
    std::optional<ResultResponse> result;
    std::optional<rclcpp::Time> over;
    std::vector<rmw_request_id_t> waiting;
  };

  template<typename ServiceT>
  using Taker = void (ServerWork::*)(
    rclcpp::Service<ServiceT> &, rmw_request_id_t &, const std::shared_ptr<typename ServiceT::Request> &);

  template<typename ServiceT>
  std::shared_ptr<rclcpp::Service<ServiceT>> add(
    const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr & node, const std::string & name,
    const rmw_qos_profile_t & qos, const rclcpp::CallbackGroup::SharedPtr & group, Taker<ServiceT> taker)
  {
    using Request = std::shared_ptr<typename ServiceT::Request>;
    auto service = std::make_shared<rclcpp::Service<ServiceT>>(
      node, name,
      [weak = this->weak_from_this(), taker](
        auto * service, const auto & header, const Request & request) {
        if (const auto self = weak.lock()) {
          (*self.*taker)(*service, *header, request);
        }
        return std::shared_ptr<typename ServiceT::Response>();  // it is sent already, or will be later
      }, qos_of(qos));
    node->add(service, group);
    return service;
  }

  void take_goal(
    rclcpp::Service<SendGoal> & service, rmw_request_id_t & header,
    const std::shared_ptr<typename SendGoal::Request> & request)
  {
    const GoalUUID id = request->goal_id.uuid;
    const std::shared_ptr<const typename ActionT::Goal> goal(request, &request->goal);
    typename SendGoal::Response response;
    const auto decision = is_known(id) ? GoalResponse::REJECT : handle_goal_(id, goal);
    std::shared_ptr<Handle> handle;
    if (decision != GoalResponse::REJECT) {
      handle = accept(id, goal, decision == GoalResponse::ACCEPT_AND_EXECUTE, response.stamp);
    }
    response.accepted = handle != nullptr;
    service.send_response(header, response);
    if (handle) {
      publish_status();
      handle_accepted_(std::move(handle));
    }
  }

  /// Nothing when somebody else was quicker to send a goal with this number.
  std::shared_ptr<Handle> accept(
    const GoalUUID & id, const std::shared_ptr<const typename ActionT::Goal> & goal, bool executes,
    builtin_interfaces::msg::Time & stamp)
  {
    stamp = clock_->now();
    auto info = rcl_action_get_zero_initialized_goal_info();
    convert(id, &info);
    Entry entry;
    entry.info.goal_id.uuid = id;
    entry.info.stamp = stamp;
    entry.state = std::make_shared<GoalState>(info);
    if (executes) {
      entry.state->update(GOAL_EVENT_EXECUTE);
    }
    const std::lock_guard lock(mutex_);
    if (find(id) != entries_.end()) {
      return nullptr;
    }
    const std::shared_ptr<Handle> handle(new Handle(entry.state, id, goal, this->weak_from_this()));
    entry.handle = handle;
    entries_.push_back(std::move(entry));
    return handle;
  }

  void take_cancel(
    rclcpp::Service<CancelGoal> & service, rmw_request_id_t & header,
    const std::shared_ptr<typename CancelGoal::Request> & request)
  {
    typename CancelGoal::Response response;
    const auto candidates = to_be_canceled(request->goal_info, response.return_code);
    for (const auto & candidate : candidates) {
      if (cancel(candidate)) {
        response.goals_canceling.push_back(candidate.info);
      }
    }
    if (!candidates.empty() && response.goals_canceling.empty()) {
      response.return_code = CancelGoal::Response::ERROR_REJECTED;
    }
    if (!response.goals_canceling.empty()) {
      publish_status();
    }
    service.send_response(header, response);
  }

  /// One goal; or all of up to a time, which may be all that there are. Says in `code` why it is none.
  std::vector<Entry> to_be_canceled(const GoalInfo & asked, std::int8_t & code)
  {
    const bool names_one = asked.goal_id.uuid != GoalUUID{};
    const rclcpp::Time until(asked.stamp);
    const bool is_timed = until.nanoseconds() != 0;
    const std::lock_guard lock(mutex_);
    drop_old_results();
    std::vector<Entry> found;
    for (const auto & entry : entries_) {
      const bool is_named = names_one && entry.info.goal_id.uuid == asked.goal_id.uuid;
      const bool is_meant = is_timed ? rclcpp::Time(entry.info.stamp) <= until : !names_one;
      if ((is_named || is_meant) && entry.state->is_cancelable()) {
        found.push_back(entry);
      }
    }
    code = CancelGoal::Response::ERROR_NONE;
    if (names_one && !is_timed && found.empty()) {
      code = find(asked.goal_id.uuid) == entries_.end() ?
        CancelGoal::Response::ERROR_UNKNOWN_GOAL_ID : CancelGoal::Response::ERROR_GOAL_TERMINATED;
    }
    return found;
  }

  bool cancel(const Entry & entry)
  {
    const auto handle = entry.handle.lock();
    if (!handle || handle_cancel_(handle) == rclcpp_action::CancelResponse::REJECT) {
      return false;
    }
    try {
      entry.state->update(GOAL_EVENT_CANCEL_GOAL);
    } catch (const rclcpp::exceptions::RCLError &) {
      return false;  // it ended while the callback thought about it
    }
    return true;
  }

  void take_result(
    rclcpp::Service<GetResult> & service, rmw_request_id_t & header,
    const std::shared_ptr<typename GetResult::Request> & request)
  {
    ResultResponse response;
    response.status = GoalStatus::STATUS_UNKNOWN;
    {
      const std::lock_guard lock(mutex_);
      drop_old_results();
      const auto entry = find(request->goal_id.uuid);
      if (entry != entries_.end() && !entry->result) {
        entry->waiting.push_back(header);
        return;
      }
      if (entry != entries_.end()) {
        response = *entry->result;
      }
    }
    service.send_response(header, response);
  }

  bool is_known(const GoalUUID & id)
  {
    const std::lock_guard lock(mutex_);
    drop_old_results();
    return find(id) != entries_.end();
  }

  // The next two are called with the lock held.
  typename std::vector<Entry>::iterator find(const GoalUUID & id)
  {
    return std::find_if(
      entries_.begin(), entries_.end(), [&](const Entry & entry) {return entry.info.goal_id.uuid == id;});
  }

  /// Everything that shows goals calls this first, so no timer is needed.
  void drop_old_results()
  {
    if (result_timeout_ < 0) {
      return;
    }
    const auto now = clock_->now();
    entries_.erase(
      std::remove_if(
        entries_.begin(), entries_.end(), [&](const Entry & entry) {
          return entry.over && (now - *entry.over).nanoseconds() > result_timeout_;
        }), entries_.end());
  }

  const rclcpp::Clock::SharedPtr clock_;
  const rcl_duration_value_t result_timeout_;
  const GoalCallback handle_goal_;
  const CancelCallback handle_cancel_;
  const AcceptedCallback handle_accepted_;
  const std::shared_ptr<rclcpp::Publisher<FeedbackMessage>> feedback_;
  const std::shared_ptr<rclcpp::Publisher<StatusMessage>> status_;
  std::shared_ptr<rclcpp::Service<GetResult>> result_;
  std::shared_ptr<rclcpp::Service<CancelGoal>> cancel_;
  std::shared_ptr<rclcpp::Service<SendGoal>> goal_;
  std::mutex mutex_;
  std::vector<Entry> entries_;  // in the order in which they were accepted
};

}  // namespace detail
}  // namespace rclcpp_action
