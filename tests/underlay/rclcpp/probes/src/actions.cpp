// actions CASE: an action server and its client in one program.

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <type_traits>
#include <unordered_set>
#include <vector>

#include "case.hpp"
#include "example_interfaces/action/fibonacci.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

using namespace std::chrono_literals;
using example_interfaces::action::Fibonacci;
using rclcpp::exceptions::RCLError;
using rclcpp_action::GoalResponse;
using rclcpp_action::ResultCode;
using CancelAnswer = rclcpp_action::Client<Fibonacci>::CancelResponse;
using ServerHandle = std::shared_ptr<rclcpp_action::ServerGoalHandle<Fibonacci>>;
using ClientHandle = rclcpp_action::ClientGoalHandle<Fibonacci>::SharedPtr;
using Options = rclcpp_action::Client<Fibonacci>::SendGoalOptions;

/// A server that keeps the handles of its goals, and a client of it.
struct Pair
{
  explicit Pair(
    std::int64_t result_timeout = RCL_S_TO_NS(10), rclcpp::CallbackGroup::SharedPtr server_group = nullptr,
    std::shared_ptr<rclcpp::Node> of = std::make_shared<rclcpp::Node>("node"))
  : node(of)
  {
    auto options = rcl_action_server_get_default_options();
    options.result_timeout.nanoseconds = result_timeout;
    server = rclcpp_action::create_server<Fibonacci>(
      node, "fibonacci",
      [this](const rclcpp_action::GoalUUID &, std::shared_ptr<const Fibonacci::Goal>) {return decision;},
      [this](const ServerHandle &) {return cancel_decision;},
      [this](const ServerHandle & handle) {handles.push_back(handle);}, options, server_group);
    client = rclcpp_action::create_client<Fibonacci>(
      node->get_node_base_interface(), node->get_node_graph_interface(),
      node->get_node_logging_interface(), node->get_node_waitables_interface(), "fibonacci");
    EXPECT(client->wait_for_action_server(20s));
  }

  template<typename FutureT>
  auto get(FutureT future)
  {
    EXPECT(rclcpp::spin_until_future_complete(node, future, 20s) == rclcpp::FutureReturnCode::SUCCESS);
    return future.get();
  }
  ClientHandle send(const Options & options = Options())
  {
    Fibonacci::Goal goal;
    goal.order = 5;
    return get(client->async_send_goal(goal, options));
  }
  void spin_until(const std::function<bool()> & holds)
  {
    const auto end = std::chrono::steady_clock::now() + 20s;
    while (!holds()) {
      EXPECT(std::chrono::steady_clock::now() < end);
      rclcpp::spin_some(node);
      std::this_thread::sleep_for(1ms);
    }
  }

  std::shared_ptr<rclcpp::Node> node;
  GoalResponse decision = GoalResponse::ACCEPT_AND_EXECUTE;
  rclcpp_action::CancelResponse cancel_decision = rclcpp_action::CancelResponse::ACCEPT;
  std::vector<ServerHandle> handles;
  rclcpp_action::Server<Fibonacci>::SharedPtr server;
  rclcpp_action::Client<Fibonacci>::SharedPtr client;
};

std::shared_ptr<Fibonacci::Result> result_of(std::vector<std::int32_t> sequence)
{
  auto result = std::make_shared<Fibonacci::Result>();
  result->sequence = sequence;
  return result;
}

void a_goal_succeeds()
{
  Pair pair;
  std::vector<std::string> calls;
  int feedbacks = 0;
  Options options;
  options.goal_response_callback = [&](const ClientHandle & handle) {calls.push_back(handle ? "yes" : "no");};
  options.feedback_callback =
    [&](ClientHandle, const std::shared_ptr<const Fibonacci::Feedback> feedback) {
      feedbacks += feedback->sequence == std::vector<std::int32_t>{0, 1};
    };
  options.result_callback = [&](const auto & result) {
      calls.push_back(result.result->sequence.size() == 3 ? "result" : "wrong");
    };
  const auto handle = pair.send(options);
  const auto & served = pair.handles.at(0);
  EXPECT(handle->get_goal_id() == served->get_goal_id() && handle->get_goal_stamp().nanoseconds() > 0);
  EXPECT(served->get_goal()->order == 5 && served->is_executing() && served->is_active());
  EXPECT(handle->is_feedback_aware() && handle->is_result_aware());
  const auto feedback = std::make_shared<Fibonacci::Feedback>();
  feedback->sequence = {0, 1};
  pair.spin_until([&]() {served->publish_feedback(feedback); return feedbacks > 0;});
  const auto future = pair.client->async_get_result(handle);
  served->succeed(result_of({0, 1, 1}));
  const auto result = pair.get(future);
  EXPECT(result.code == ResultCode::SUCCEEDED && result.goal_id == handle->get_goal_id());
  EXPECT(result.result->sequence == std::vector<std::int32_t>({0, 1, 1}));
  EXPECT(calls == std::vector<std::string>({"yes", "result"}));
  EXPECT(handle->get_status() == rclcpp_action::GoalStatus::STATUS_SUCCEEDED && !served->is_active());
  using Unknown = rclcpp_action::exceptions::UnknownGoalHandleError;
  EXPECT(
    THROWN(Unknown, pair.client->async_get_result(handle)) == "Goal handle is not known to this client.");
  EXPECT(!THROWN(std::invalid_argument, pair.client->async_cancel_goal(handle)).empty());
}

void a_goal_is_rejected()
{
  Pair pair;
  pair.decision = GoalResponse::REJECT;
  int nulls = 0;
  Options options;
  options.goal_response_callback = [&](const ClientHandle & handle) {nulls += handle == nullptr;};
  EXPECT(pair.send(options) == nullptr && nulls == 1 && pair.handles.empty());
}

void a_goal_is_aborted()
{
  Pair pair;
  const auto handle = pair.send();
  pair.handles.at(0)->abort(result_of({7}));
  const auto result = pair.get(pair.client->async_get_result(handle));  // asked for after it was over
  EXPECT(result.code == ResultCode::ABORTED && result.result->sequence.at(0) == 7);
}

void a_goal_is_canceled()
{
  Pair pair;
  const auto handle = pair.send();
  const auto & served = pair.handles.at(0);
  pair.cancel_decision = rclcpp_action::CancelResponse::REJECT;
  auto answer = pair.get(pair.client->async_cancel_goal(handle));
  EXPECT(answer->return_code == CancelAnswer::ERROR_REJECTED && answer->goals_canceling.empty());
  EXPECT(!served->is_canceling());
  pair.cancel_decision = rclcpp_action::CancelResponse::ACCEPT;
  int called = 0;
  answer = pair.get(pair.client->async_cancel_goal(handle, [&](const auto &) {++called;}));
  EXPECT(answer->return_code == CancelAnswer::ERROR_NONE && answer->goals_canceling.size() == 1);
  EXPECT(called == 1 && served->is_canceling() && served->is_active() && !served->is_executing());
  answer = pair.get(pair.client->async_cancel_goal(handle));
  EXPECT(answer->return_code == CancelAnswer::ERROR_GOAL_TERMINATED);
  served->canceled(result_of({1}));
  EXPECT(pair.get(pair.client->async_get_result(handle)).code == ResultCode::CANCELED);
}

void goals_are_canceled_together()
{
  Pair pair;
  EXPECT(pair.get(pair.client->async_cancel_all_goals())->return_code == CancelAnswer::ERROR_NONE);
  const auto first = pair.send(), second = pair.send();
  const auto early = pair.get(pair.client->async_cancel_goals_before(first->get_goal_stamp()));
  EXPECT(early->goals_canceling.size() == 1);
  EXPECT(early->goals_canceling.at(0).goal_id.uuid == first->get_goal_id());
  const auto rest = pair.get(pair.client->async_cancel_all_goals());
  EXPECT(rest->goals_canceling.size() == 1 && pair.handles.at(1)->is_canceling());
}

void wrong_states_throw()
{
  Pair pair;
  pair.decision = GoalResponse::ACCEPT_AND_DEFER;
  const auto handle = pair.send();
  const auto & served = pair.handles.at(0);
  EXPECT(served->is_active() && !served->is_executing());
  EXPECT(!THROWN(RCLError, served->succeed(result_of({}))).empty());
  served->execute();
  EXPECT(served->is_executing());
  pair.spin_until([&]() {return handle->get_status() == rclcpp_action::GoalStatus::STATUS_EXECUTING;});
  EXPECT(THROWN(RCLError, served->execute()).find("invalid transition") != std::string::npos);
  EXPECT(!THROWN(RCLError, served->canceled(result_of({}))).empty());
  served->succeed(result_of({1}));
  EXPECT(!THROWN(RCLError, served->abort(result_of({2}))).empty());
  EXPECT(pair.get(pair.client->async_get_result(handle)).code == ResultCode::SUCCEEDED);
}

void a_handle_let_go_cancels_its_goal()
{
  Pair pair;
  const auto future = pair.client->async_get_result(pair.send());
  pair.handles.clear();
  EXPECT(pair.get(future).code == ResultCode::CANCELED);
}

void results_are_kept_for_a_time()
{
  Pair pair(0);
  const auto handle = pair.send();
  pair.handles.at(0)->succeed(result_of({1}));
  EXPECT(pair.get(pair.client->async_get_result(handle)).code == ResultCode::UNKNOWN);
  Pair patient(-1, nullptr, std::make_shared<rclcpp::Node>("other", "space"));
  const auto kept = patient.send();
  patient.handles.at(0)->succeed(result_of({1}));
  EXPECT(patient.get(patient.client->async_get_result(kept)).code == ResultCode::SUCCEEDED);
}

void each_side_may_go_first()
{
  Pair pair;
  const auto handle = pair.send();
  const auto future = pair.client->async_get_result(handle);
  pair.client.reset();
  using Unaware = rclcpp_action::exceptions::UnawareGoalHandleError;
  EXPECT(THROWN(Unaware, future.get()) == "Goal handle is not tracking the goal result.");
  EXPECT(!handle->is_result_aware());
  pair.server.reset();
  pair.handles.at(0)->succeed(result_of({1}));  // nobody hears it
  const auto client = rclcpp_action::create_client<Fibonacci>(pair.node, "nobody_serves_it");
  EXPECT(!client->action_server_is_ready() && !client->wait_for_action_server(0s));
  EXPECT(!client->wait_for_action_server(10ms));
  EXPECT(!THROWN(std::invalid_argument, rclcpp_action::create_client<Fibonacci>(pair.node, "")).empty());
}

void callbacks_stop()
{
  Pair pair;
  int called = 0;
  Options options;
  options.result_callback = [&](const auto &) {++called;};
  const auto handle = pair.send(options);
  const auto future = pair.client->async_get_result(handle);
  pair.client->stop_callbacks(handle->get_goal_id());
  pair.handles.at(0)->succeed(result_of({1}));
  EXPECT(pair.get(future).code == ResultCode::SUCCEEDED && called == 0);
}

void a_server_keeps_to_its_group()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  const auto group = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  Pair pair(RCL_S_TO_NS(10), group, node);
  const auto future = pair.client->async_send_goal(Fibonacci::Goal());
  for (int i = 0; i < 20; ++i) {
    rclcpp::spin_some(node);
  }
  EXPECT(future.wait_for(0s) == std::future_status::timeout);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_callback_group(group, node->get_node_base_interface());
  std::thread spinning([&]() {executor.spin();});
  const auto code = rclcpp::spin_until_future_complete(node, future, 20s);
  executor.cancel();
  spinning.join();
  EXPECT(code == rclcpp::FutureReturnCode::SUCCESS && future.get() != nullptr);
}

void many_goals_in_many_threads()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  const auto group = node->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
  std::mutex mutex;
  std::vector<std::thread> threads;
  const auto server = rclcpp_action::create_server<Fibonacci>(
    node, "fibonacci", [](const auto &, auto) {return GoalResponse::ACCEPT_AND_EXECUTE;},
    [](const auto &) {return rclcpp_action::CancelResponse::ACCEPT;},
    [&](ServerHandle handle) {
      const std::lock_guard lock(mutex);
      threads.emplace_back([handle]() {handle->succeed(result_of({handle->get_goal()->order}));});
    }, rcl_action_server_get_default_options(), group);
  const auto client = rclcpp_action::create_client<Fibonacci>(node, "fibonacci", group);
  rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 4);
  executor.add_node(node);
  std::thread spinning([&]() {executor.spin();});
  EXPECT(client->wait_for_action_server(20s));
  std::set<int> orders;
  Options options;
  options.result_callback = [&](const auto & result) {
      const std::lock_guard lock(mutex);
      orders.insert(result.result->sequence.at(0));
    };
  const auto have_come = [&](std::size_t count) {
      const std::lock_guard lock(mutex);
      return orders.size() == count;
    };
  std::vector<std::shared_future<ClientHandle>> sent;
  std::unordered_set<rclcpp_action::GoalUUID> ids;
  const auto end = std::chrono::steady_clock::now() + 60s;
  for (int wave = 0; wave < 5; ++wave) {
    for (int i = 0; i < 8; ++i) {  // the middleware keeps ten requests
      Fibonacci::Goal goal;
      goal.order = 8 * wave + i;
      sent.push_back(client->async_send_goal(goal, options));
    }
    while (!have_come(sent.size()) && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(1ms);
    }
  }
  executor.cancel();
  spinning.join();
  for (auto & thread : threads) {
    thread.join();
  }
  EXPECT(orders.size() == sent.size());
  for (auto & future : sent) {
    ids.insert(future.get()->get_goal_id());
  }
  EXPECT(ids.size() == sent.size());
}

void numbers_have_the_usual_form()
{
  rclcpp_action::GoalUUID id{}, back{};
  id.front() = 0x0a;
  id.back() = 0xf1;
  EXPECT(rclcpp_action::to_string(id) == "0a000000-0000-0000-0000-0000000000f1");
  rcl_action_goal_info_t info = rcl_action_get_zero_initialized_goal_info();
  rclcpp_action::convert(id, &info);
  rclcpp_action::convert(info, &back);
  EXPECT(id == back);
}

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const Cases cases{
    {"a_goal_succeeds", a_goal_succeeds},
    {"a_goal_is_rejected", a_goal_is_rejected},
    {"a_goal_is_aborted", a_goal_is_aborted},
    {"a_goal_is_canceled", a_goal_is_canceled},
    {"goals_are_canceled_together", goals_are_canceled_together},
    {"wrong_states_throw", wrong_states_throw},
    {"a_handle_let_go_cancels_its_goal", a_handle_let_go_cancels_its_goal},
    {"results_are_kept_for_a_time", results_are_kept_for_a_time},
    {"each_side_may_go_first", each_side_may_go_first},
    {"callbacks_stop", callbacks_stop},
    {"a_server_keeps_to_its_group", a_server_keeps_to_its_group},
    {"many_goals_in_many_threads", many_goals_in_many_threads},
    {"numbers_have_the_usual_form", numbers_have_the_usual_form},
  };
  const int code = run_case(cases, argv[1]);
  rclcpp::shutdown();
  return code;
}
