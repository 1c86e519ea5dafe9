// executors CASE: what executors and callback groups promise; 0 when it holds.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "case.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"

using namespace std::chrono_literals;
using rclcpp::executors::MultiThreadedExecutor;
using rclcpp::executors::SingleThreadedExecutor;
using std_msgs::msg::String;
using std_srvs::srv::Trigger;

/// Two that must be here at the same time.
class Meeting
{
public:
  bool met()
  {
    std::unique_lock lock(mutex_);
    ++here_;
    changed_.notify_all();
    return changed_.wait_for(lock, 10s, [this]() {return here_ >= 2;});
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int here_ = 0;
};

void reentrant_callbacks_meet()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  const auto group = node->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
  Meeting meeting;
  std::atomic_int met{0};
  MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 2);
  std::vector<rclcpp::TimerBase::SharedPtr> timers(2);
  for (auto & timer : timers) {
    timer = node->create_wall_timer(
      1ms, [&]() {
        timer->cancel();
        if (meeting.met() && ++met == 2) {
          executor.cancel();
        }
      }, group);
  }
  executor.add_node(node);
  executor.spin();
  EXPECT(met == 2);
}

void exclusive_callbacks_never_meet()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  const auto group = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
  std::atomic_int here{0}, most{0}, calls{0};
  MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 4);
  const auto work = [&]() {
      most = std::max<int>(most, ++here);
      std::this_thread::yield();
      --here;
      if (++calls == 200) {
        executor.cancel();
      }
    };
  std::vector<rclcpp::TimerBase::SharedPtr> timers;
  for (int i = 0; i < 4; ++i) {
    timers.push_back(node->create_wall_timer(100us, work, group));
  }
  executor.add_node(node);
  executor.spin();
  EXPECT(calls >= 200);
  EXPECT(most == 1);
}

void groups_do_not_wait_for_each_other()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  const auto other = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
  auto service = node->create_service<Trigger>(
    "go", [](const Trigger::Request::SharedPtr, Trigger::Response::SharedPtr response) {
      response->success = true;
    });
  auto client = node->create_client<Trigger>("go", rclcpp::ServicesQoS(), other);
  MultiThreadedExecutor executor;
  bool answered = false;
  const auto mine = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
  rclcpp::TimerBase::SharedPtr timer;
  timer = node->create_wall_timer(
    1ms, [&]() {
      timer->cancel();
      auto future = client->async_send_request(std::make_shared<Trigger::Request>());
      answered = future.wait_for(10s) == std::future_status::ready;
      executor.cancel();
    }, mine);
  executor.add_node(node);
  executor.spin();
  EXPECT(answered);
}

void timers_take_turns_by_their_periods()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  int slow = 0, fast = 0;
  SingleThreadedExecutor executor;
  auto fast_timer = node->create_wall_timer(2ms, [&]() {++fast;});
  auto slow_timer = node->create_wall_timer(
    20ms, [&]() {
      if (++slow == 5) {
        executor.cancel();
      }
    });
  executor.add_node(node);
  executor.spin();
  EXPECT(slow == 5);
  EXPECT(fast > slow);
}

void a_canceled_timer_rests()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  int calls = 0;
  auto timer = node->create_wall_timer(1ms, [&](rclcpp::TimerBase & self) {++calls; self.cancel();});
  auto never = node->create_wall_timer(1ms, [&]() {calls += 1000;}, nullptr, false);
  std::promise<void> done;
  rclcpp::TimerBase::SharedPtr end;
  end = node->create_wall_timer(30ms, [&]() {done.set_value(); end->cancel();});
  rclcpp::spin_until_future_complete(node, done.get_future());
  EXPECT(calls == 1);
  EXPECT(timer->is_canceled());
  EXPECT(timer->time_until_trigger() == std::chrono::nanoseconds::max());
  timer->reset();
  EXPECT(!timer->is_canceled());
}

void spin_some_does_what_is_ready()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  int calls = 0;
  auto timer = node->create_wall_timer(0ms, [&]() {++calls;});
  rclcpp::spin_some(node);
  EXPECT(calls == 1);
  rclcpp::spin_some(node->get_node_base_interface());
  EXPECT(calls == 2);
  timer->cancel();
  rclcpp::spin_some(node);
  EXPECT(calls == 2);
}

void spin_all_goes_on_until_nothing_is_ready()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  std::vector<std::string> heard;
  auto subscription = node->create_subscription<String>(
    "topic", rclcpp::QoS(10), [&](const String & message) {heard.push_back(message.data);});
  auto publisher = node->create_publisher<String>("topic", rclcpp::QoS(10));
  std::promise<void> matched;
  rclcpp::TimerBase::SharedPtr wait;
  wait = node->create_wall_timer(
    1ms, [&]() {
      if (publisher->get_subscription_count() == 1 && subscription->get_publisher_count() == 1) {
        wait->cancel();
        matched.set_value();
      }
    });
  rclcpp::spin_until_future_complete(node, matched.get_future());
  for (const char * word : {"a", "b", "c"}) {
    String message;
    message.data = word;
    publisher->publish(message);
  }
  EXPECT(publisher->wait_for_all_acked(10s));
  SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin_all(10s);
  EXPECT(heard == std::vector<std::string>{"a", "b", "c"});
}

void what_is_added_while_spinning_is_heard()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  SingleThreadedExecutor executor;
  executor.add_node(node);
  std::thread spinning([&]() {executor.spin();});
  std::promise<void> called;
  rclcpp::TimerBase::SharedPtr timer;
  timer = node->create_wall_timer(1ms, [&]() {called.set_value(); timer->cancel();});
  const bool heard = called.get_future().wait_for(10s) == std::future_status::ready;
  executor.cancel();
  spinning.join();
  EXPECT(heard);
}

void additions_to_a_group_are_heard()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  rclcpp::SubscriptionOptions options;
  options.callback_group =
    node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  SingleThreadedExecutor executor, other;
  executor.add_callback_group(options.callback_group, node->get_node_base_interface());
  other.add_node(node);
  std::promise<void> waits, called;
  rclcpp::TimerBase::SharedPtr timer;
  timer = node->create_wall_timer(
    0ms, [&]() {timer->cancel(); waits.set_value();}, options.callback_group);
  std::thread spinning([&]() {executor.spin();});
  waits.get_future().wait();  // it waits from now on, and for no timer
  const auto kept = rclcpp::QoS(1).transient_local();
  auto subscription = node->create_subscription<String>(
    "topic", kept, [&](const String &) {called.set_value();}, options);
  auto publisher = node->create_publisher<String>("topic", kept);
  publisher->publish(String());
  const bool heard = called.get_future().wait_for(10s) == std::future_status::ready;
  executor.cancel();
  spinning.join();
  EXPECT(heard);
}

void a_group_of_its_own_has_its_own_executor()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  const auto group =
    node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  int mine = 0, others = 0;
  auto timer = node->create_wall_timer(0ms, [&]() {++mine;}, group);
  auto other = node->create_wall_timer(0ms, [&]() {++others;});
  SingleThreadedExecutor first, second;
  first.add_node(node);
  second.add_callback_group(group, node->get_node_base_interface());
  first.spin_some();
  EXPECT(mine == 0 && others == 1);
  second.spin_some();
  EXPECT(mine == 1 && others == 1);
  const auto base = node->get_node_base_interface();
  EXPECT(!THROWN(std::runtime_error, first.add_callback_group(group, base)).empty());
}

void wrong_use_is_said()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  SingleThreadedExecutor executor, other;
  executor.add_node(node);
  EXPECT(
    THROWN(std::runtime_error, other.add_node(node)) ==
    "Node '/node' has already been added to an executor.");
  EXPECT(
    THROWN(std::runtime_error, other.remove_node(node)) ==
    "Node '/node' needs to be associated with this executor.");
  const auto base = node->get_node_base_interface();
  const auto group = base->get_default_callback_group();
  const std::string added = "Callback group has already been added to an executor.";
  EXPECT(THROWN(std::runtime_error, other.add_callback_group(group, base)) == added);
  executor.remove_node(node);
  EXPECT(
    THROWN(std::runtime_error, executor.remove_node(node)) ==
    "Node '/node' needs to be associated with an executor.");
  executor.add_callback_group(group, base);
  EXPECT(THROWN(std::runtime_error, executor.add_callback_group(group, base)) == added);
  group->get_associated_with_executor_atomic() = false;
  EXPECT(
    THROWN(std::runtime_error, executor.add_callback_group(group, base)) ==
    "Callback group has already been added to this executor.");
  EXPECT(
    THROWN(std::runtime_error, other.remove_callback_group(group)) ==
    "Callback group needs to be associated with this executor.");
  executor.remove_callback_group(group);
  EXPECT(
    THROWN(std::runtime_error, executor.remove_callback_group(group)) ==
    "Callback group needs to be associated with an executor.");
  other.add_node(node);
  auto timer = node->create_wall_timer(0ms, [&]() {other.spin_some();});
  EXPECT(THROWN(std::runtime_error, other.spin_some()) == "spin_some() called while already spinning");
}

void futures_end_or_time_out()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  std::promise<int> promise;
  auto future = promise.get_future().share();
  EXPECT(rclcpp::spin_until_future_complete(node, future, 5ms) == rclcpp::FutureReturnCode::TIMEOUT);
  rclcpp::TimerBase::SharedPtr timer;
  timer = node->create_wall_timer(1ms, [&]() {promise.set_value(7); timer->cancel();});
  EXPECT(rclcpp::spin_until_future_complete(node, future) == rclcpp::FutureReturnCode::SUCCESS);
  EXPECT(future.get() == 7);
  std::promise<void> never;
  auto end = node->create_wall_timer(1ms, []() {rclcpp::shutdown();});
  const auto code = rclcpp::spin_until_future_complete(node, never.get_future());
  EXPECT(code == rclcpp::FutureReturnCode::INTERRUPTED);
}

void changes_of_parameters_are_handled()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  node->declare_parameter("watched", 1);
  node->declare_parameter("other", 1);
  rclcpp::ParameterEventHandler handler(node);
  std::promise<std::int64_t> seen;
  int times = 0, all = 0;
  auto one = handler.add_parameter_callback(
    "watched", [&](const rclcpp::Parameter & parameter) {
      if (++times == 1) {
        seen.set_value(parameter.as_int());
      }
    });
  auto every = handler.add_parameter_event_callback([&](const auto &) {++all;});
  // Again and again: who hears it must first have been found.
  auto timer = node->create_wall_timer(
    5ms, [&]() {
      node->set_parameter({"other", 2});
      node->set_parameter({"watched", 3});
    });
  auto future = seen.get_future();
  EXPECT(rclcpp::spin_until_future_complete(node, future, 20s) == rclcpp::FutureReturnCode::SUCCESS);
  EXPECT(future.get() == 3);
  rclcpp::spin_some(node);
  EXPECT(all >= times);
  handler.remove_parameter_callback(one);
  EXPECT(!THROWN(std::runtime_error, handler.remove_parameter_callback(one)).empty());
}

void the_first_exception_ends_all_threads()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  const auto group = node->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
  Meeting meeting;
  MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 3);
  std::vector<rclcpp::TimerBase::SharedPtr> timers(2);
  for (auto & timer : timers) {
    timer = node->create_wall_timer(
      1ms, [&]() {
        timer->cancel();
        meeting.met();  // in two threads, so one of them is not the one that spins
        throw std::runtime_error("from a callback");
      }, group);
  }
  executor.add_node(node);
  EXPECT(THROWN(std::runtime_error, executor.spin()) == "from a callback");
  EXPECT(!executor.is_spinning());
  auto end = node->create_wall_timer(1ms, [&]() {executor.cancel();}, group);
  executor.spin();
}

void an_exception_leaves_the_node_free()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  auto timer = node->create_wall_timer(0ms, []() {throw std::runtime_error("from a callback");});
  const auto base = node->get_node_base_interface();
  SingleThreadedExecutor executor;
  EXPECT(!THROWN(std::runtime_error, executor.spin_node_once(base)).empty());
  EXPECT(!THROWN(std::runtime_error, executor.spin_node_some(base)).empty());
  std::promise<void> promise;
  const auto future = promise.get_future();
  EXPECT(
    THROWN(
      std::runtime_error,
      rclcpp::executors::spin_node_until_future_complete(executor, node, future)) == "from a callback");
  executor.add_node(node);
}

void a_node_may_go_while_it_is_spun()
{
  auto goes = std::make_shared<rclcpp::Node>("goes");
  auto stays = std::make_shared<rclcpp::Node>("stays");
  std::promise<void> called;
  MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 2);
  executor.add_node(goes);
  executor.add_node(stays);
  std::thread spinning([&]() {executor.spin();});
  rclcpp::TimerBase::SharedPtr first;
  first = goes->create_wall_timer(1ms, [&]() {called.set_value(); first->cancel();});
  called.get_future().wait();
  std::weak_ptr<rclcpp::Node> gone = goes;
  goes.reset();
  EXPECT(gone.expired());
  std::promise<void> again;
  rclcpp::TimerBase::SharedPtr second;
  second = stays->create_wall_timer(1ms, [&]() {again.set_value(); second->cancel();});
  const bool heard = again.get_future().wait_for(10s) == std::future_status::ready;
  executor.cancel();
  spinning.join();
  EXPECT(heard);
}

void requests_are_forgotten()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  int asked = 0;
  auto service = node->create_service<Trigger>(
    "go", [&](const Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) {++asked;});
  auto client = node->create_client<Trigger>("go");
  EXPECT(client->wait_for_service(10s));
  const auto request = std::make_shared<Trigger::Request>();
  auto forgotten = client->async_send_request(request);
  EXPECT(client->remove_pending_request(forgotten) && !client->remove_pending_request(forgotten));
  EXPECT(!THROWN(std::future_error, forgotten.get()).empty());
  bool told = false;
  const auto silent = client->async_send_request(request, [&](auto) {told = true;});
  EXPECT(client->remove_pending_request(silent.request_id));
  auto kept = client->async_send_request(request);
  EXPECT(rclcpp::spin_until_future_complete(node, kept, 10s) == rclcpp::FutureReturnCode::SUCCESS);
  EXPECT(asked == 3 && !told);
  client->async_send_request(request);
  std::vector<std::int64_t> old;
  EXPECT(client->prune_requests_older_than(std::chrono::system_clock::now() + 1h, &old) == 1);
  EXPECT(old.size() == 1 && client->prune_pending_requests() == 0);
}

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const Cases cases{
    {"reentrant_callbacks_meet", reentrant_callbacks_meet},
    {"exclusive_callbacks_never_meet", exclusive_callbacks_never_meet},
    {"groups_do_not_wait_for_each_other", groups_do_not_wait_for_each_other},
    {"timers_take_turns_by_their_periods", timers_take_turns_by_their_periods},
    {"a_canceled_timer_rests", a_canceled_timer_rests},
    {"spin_some_does_what_is_ready", spin_some_does_what_is_ready},
    {"spin_all_goes_on_until_nothing_is_ready", spin_all_goes_on_until_nothing_is_ready},
    {"what_is_added_while_spinning_is_heard", what_is_added_while_spinning_is_heard},
    {"additions_to_a_group_are_heard", additions_to_a_group_are_heard},
    {"a_group_of_its_own_has_its_own_executor", a_group_of_its_own_has_its_own_executor},
    {"wrong_use_is_said", wrong_use_is_said},
    {"futures_end_or_time_out", futures_end_or_time_out},
    {"changes_of_parameters_are_handled", changes_of_parameters_are_handled},
    {"the_first_exception_ends_all_threads", the_first_exception_ends_all_threads},
    {"an_exception_leaves_the_node_free", an_exception_leaves_the_node_free},
    {"a_node_may_go_while_it_is_spun", a_node_may_go_while_it_is_spun},
    {"requests_are_forgotten", requests_are_forgotten},
  };
  const int code = run_case(cases, argv[1]);
  rclcpp::shutdown();
  return code;
}
