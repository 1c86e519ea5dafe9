#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <utility>

#include "rcl_action/action_client.h"
#include "rclcpp/client.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_graph_interface.hpp"
#include "rclcpp/node_interfaces/node_logging_interface.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp_action/client_goal_handle.hpp"
#include "rclcpp_action/detail/names.hpp"
#include "rclcpp_action/exceptions.hpp"
#include "rclcpp_action/types.hpp"

namespace rclcpp_action
{

/// What action clients of all types have in common.
class ClientBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(ClientBase)
  virtual ~ClientBase() = default;

  /// Whether all of the server is there: its services and its topics.
  virtual bool action_server_is_ready() const = 0;

  /// Waits for the server; a negative time waits for ever. False when it did not come, or the context ended.
  template<typename RepT = std::int64_t, typename RatioT = std::milli>
  bool wait_for_action_server(
    std::chrono::duration<RepT, RatioT> timeout = std::chrono::duration<RepT, RatioT>(-1))
  {
    return graph_->wait_until(
      [this]() {return action_server_is_ready();},
      std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }

protected:
  explicit ClientBase(rclcpp::node_interfaces::NodeGraphInterface::SharedPtr graph)
  : graph_(std::move(graph)) {}

  static GoalUUID generate_goal_id()
  {
    std::random_device random;
    std::uniform_int_distribution<int> bytes(0, UINT8_MAX);
    GoalUUID id;
    std::generate(id.begin(), id.end(), [&]() {return static_cast<std::uint8_t>(bytes(random));});
    return id;
  }

  rclcpp::node_interfaces::NodeGraphInterface::SharedPtr graph_;
};

/// Sends goals to a server. To be made by create_client: it lives in a shared pointer.
template<typename ActionT>
class Client : public ClientBase, public std::enable_shared_from_this<Client<ActionT>>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(Client<ActionT>)

  using Goal = typename ActionT::Goal;
  using Feedback = typename ActionT::Feedback;
  using GoalHandle = ClientGoalHandle<ActionT>;
  using WrappedResult = typename GoalHandle::WrappedResult;
  using GoalResponseCallback = std::function<void(typename GoalHandle::SharedPtr)>;
  using FeedbackCallback = typename GoalHandle::FeedbackCallback;
  using ResultCallback = typename GoalHandle::ResultCallback;
  using CancelRequest = typename ActionT::Impl::CancelGoalService::Request;
  using CancelResponse = typename ActionT::Impl::CancelGoalService::Response;
  using CancelCallback = std::function<void(typename CancelResponse::SharedPtr)>;

  struct SendGoalOptions
  {
    /// Gets a null pointer when the server rejects the goal.
    GoalResponseCallback goal_response_callback;
    FeedbackCallback feedback_callback;
    /// Where there is one, the result is asked for at once.
    ResultCallback result_callback;
  };

  Client(
    const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr & node,
    rclcpp::node_interfaces::NodeGraphInterface::SharedPtr graph,
    const rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr & /*logging*/,
    const std::string & action_name,
    const rcl_action_client_options_t & options = rcl_action_client_get_default_options(),
    const rclcpp::CallbackGroup::SharedPtr & group = nullptr)
  : ClientBase(std::move(graph)),
    goal_client_(
      std::make_shared<rclcpp::Client<SendGoal>>(
        node, detail::part_of(action_name, "send_goal"), detail::qos_of(options.goal_service_qos))),
    cancel_client_(
      std::make_shared<rclcpp::Client<CancelGoal>>(
        node, detail::part_of(action_name, "cancel_goal"), detail::qos_of(options.cancel_service_qos))),
    result_client_(
      std::make_shared<rclcpp::Client<GetResult>>(
        node, detail::part_of(action_name, "get_result"), detail::qos_of(options.result_service_qos))),
    feedback_(
      std::make_shared<rclcpp::Subscription<FeedbackMessage>>(
        node, detail::part_of(action_name, "feedback"), detail::qos_of(options.feedback_topic_qos),
        [goals = goals_](std::shared_ptr<FeedbackMessage> message, const rclcpp::MessageInfo &) {
          goals->tell(message);
        }, rclcpp::SubscriptionOptions())),
    status_(
      std::make_shared<rclcpp::Subscription<StatusMessage>>(
        node, detail::part_of(action_name, "status"), detail::qos_of(options.status_topic_qos),
        [goals = goals_](std::shared_ptr<StatusMessage> message, const rclcpp::MessageInfo &) {
          goals->update(*message);
        }, rclcpp::SubscriptionOptions()))
  {
    node->add(goal_client_, group);
    node->add(cancel_client_, group);
    node->add(result_client_, group);
    node->add(feedback_, group);
    node->add(status_, group);
  }

  /// Those who wait for a result get UnawareGoalHandleError.
  ~Client() override
  {
    for (const auto & [id, known] : goals_->release()) {
      if (const auto handle = known.lock()) {
        handle->invalidate();
      }
    }
  }

  bool action_server_is_ready() const override
  {
    return goal_client_->service_is_ready() && cancel_client_->service_is_ready() &&
           result_client_->service_is_ready() && feedback_->get_publisher_count() > 0 &&
           status_->get_publisher_count() > 0;
  }

  /// Sends a goal; the future, which is ready once the node has spun, contains a null pointer for a goal that
  /// was rejected. The goal's callbacks and result come as long as somebody holds its handle.
  std::shared_future<typename GoalHandle::SharedPtr> async_send_goal(
    const Goal & goal, const SendGoalOptions & options = SendGoalOptions())
  {
    const auto promise = std::make_shared<std::promise<typename GoalHandle::SharedPtr>>();
    const std::shared_future<typename GoalHandle::SharedPtr> future(promise->get_future());
    const auto request = std::make_shared<typename SendGoal::Request>();
    request->goal_id.uuid = generate_goal_id();
    request->goal = goal;
    goal_client_->async_send_request(
      request, [weak = this->weak_from_this(), id = request->goal_id, options, promise](
        typename rclcpp::Client<SendGoal>::SharedFuture answer) {
        if (const auto self = weak.lock()) {
          self->take_answer(*answer.get(), id, options, *promise);
        }
      });
    return future;
  }

  /// Throws UnknownGoalHandleError for a goal that is over or another client's.
  std::shared_future<WrappedResult> async_get_result(
    typename GoalHandle::SharedPtr goal_handle, ResultCallback result_callback = nullptr)
  {
    check_known(goal_handle);
    if (result_callback) {
      goal_handle->set_result_callback(std::move(result_callback));
    }
    ask_for_result(goal_handle);
    return goal_handle->future_;
  }

  /// Throws UnknownGoalHandleError for a goal that is over or another client's.
  std::shared_future<typename CancelResponse::SharedPtr> async_cancel_goal(
    typename GoalHandle::SharedPtr goal_handle, CancelCallback cancel_callback = nullptr)
  {
    check_known(goal_handle);
    auto request = std::make_shared<CancelRequest>();
    request->goal_info.goal_id.uuid = goal_handle->get_goal_id();
    return cancel(std::move(request), std::move(cancel_callback));
  }

  /// Those of other clients, too.
  std::shared_future<typename CancelResponse::SharedPtr> async_cancel_all_goals(
    CancelCallback cancel_callback = nullptr)
  {
    return cancel(std::make_shared<CancelRequest>(), std::move(cancel_callback));
  }

  /// All that were accepted at that time or before it.
  std::shared_future<typename CancelResponse::SharedPtr> async_cancel_goals_before(
    const rclcpp::Time & stamp, CancelCallback cancel_callback = nullptr)
  {
    auto request = std::make_shared<CancelRequest>();
    request->goal_info.stamp = stamp;
    return cancel(std::move(request), std::move(cancel_callback));
  }

  /// No feedback and no result of this goal is called back any more.
  void stop_callbacks(typename GoalHandle::SharedPtr goal_handle) {goal_handle->stop_callbacks();}
  void stop_callbacks(const GoalUUID & goal_id)
  {
    if (const auto handle = goals_->find(goal_id)) {
      handle->stop_callbacks();
    }
  }

private:
  using SendGoal = typename ActionT::Impl::SendGoalService;
  using CancelGoal = typename ActionT::Impl::CancelGoalService;
  using GetResult = typename ActionT::Impl::GetResultService;
  using FeedbackMessage = typename ActionT::Impl::FeedbackMessage;
  using StatusMessage = typename ActionT::Impl::GoalStatusMessage;

  /// The goals that were accepted and are not over. Subscriptions share it, so they never hold the client.
  class Goals
  {
  public:
    using Known = std::map<GoalUUID, typename GoalHandle::WeakPtr>;

    void add(const typename GoalHandle::SharedPtr & handle)
    {
      const std::lock_guard lock(mutex_);
      for (auto it = known_.begin(); it != known_.end(); ) {
        it = it->second.expired() ? known_.erase(it) : std::next(it);
      }
      known_[handle->get_goal_id()] = handle;
    }
    void remove(const GoalUUID & id)
    {
      const std::lock_guard lock(mutex_);
      known_.erase(id);
    }
    typename GoalHandle::SharedPtr find(const GoalUUID & id)
    {
      const std::lock_guard lock(mutex_);
      const auto found = known_.find(id);
      return found == known_.end() ? nullptr : found->second.lock();
    }
    Known release()
    {
      const std::lock_guard lock(mutex_);
      return std::exchange(known_, Known());
    }
    void tell(const std::shared_ptr<FeedbackMessage> & message)
    {
      if (const auto handle = find(message->goal_id.uuid)) {
        if (const auto callback = handle->feedback_callback()) {
          callback(handle, std::shared_ptr<const Feedback>(message, &message->feedback));
        }
      }
    }
    void update(const StatusMessage & message)
    {
      for (const auto & status : message.status_list) {
        if (const auto handle = find(status.goal_info.goal_id.uuid)) {
          handle->set_status(status.status);
        }
      }
    }

  private:
    std::mutex mutex_;
    Known known_;
  };

  void check_known(const typename GoalHandle::SharedPtr & handle)
  {
    if (goals_->find(handle->get_goal_id()) != handle) {
      throw exceptions::UnknownGoalHandleError();
    }
  }

  template<typename IdT>
  void take_answer(
    const typename SendGoal::Response & answer, const IdT & id, const SendGoalOptions & options,
    std::promise<typename GoalHandle::SharedPtr> & promise)
  {
    typename GoalHandle::SharedPtr handle;
    if (answer.accepted) {
      GoalInfo info;
      info.goal_id = id;
      info.stamp = answer.stamp;
      handle.reset(new GoalHandle(info, options.feedback_callback, options.result_callback));
      goals_->add(handle);
    }
    promise.set_value(handle);
    if (options.goal_response_callback) {
      options.goal_response_callback(handle);
    }
    if (handle && options.result_callback) {
      ask_for_result(handle);
    }
  }

  void ask_for_result(const typename GoalHandle::SharedPtr & handle)
  {
    if (handle->become_result_aware()) {
      return;
    }
    const auto request = std::make_shared<typename GetResult::Request>();
    request->goal_id.uuid = handle->get_goal_id();
    result_client_->async_send_request(
      request, [goals = goals_, handle](typename rclcpp::Client<GetResult>::SharedFuture answer) {
        const auto & response = answer.get();
        goals->remove(handle->get_goal_id());
        handle->set_result(
          {handle->get_goal_id(), static_cast<ResultCode>(response->status),
            std::shared_ptr<typename ActionT::Result>(response, &response->result)});
      });
  }

  std::shared_future<typename CancelResponse::SharedPtr> cancel(
    std::shared_ptr<CancelRequest> request, CancelCallback callback)
  {
    return cancel_client_->async_send_request(
      std::move(request),
      [callback = std::move(callback)](typename rclcpp::Client<CancelGoal>::SharedFuture answer) {
        if (callback) {
          callback(answer.get());
        }
      }).future;
  }

  const std::shared_ptr<Goals> goals_ = std::make_shared<Goals>();
  const std::shared_ptr<rclcpp::Client<SendGoal>> goal_client_;
  const std::shared_ptr<rclcpp::Client<CancelGoal>> cancel_client_;
  const std::shared_ptr<rclcpp::Client<GetResult>> result_client_;
  const std::shared_ptr<rclcpp::Subscription<FeedbackMessage>> feedback_;
  const std::shared_ptr<rclcpp::Subscription<StatusMessage>> status_;
};

}  // namespace rclcpp_action
