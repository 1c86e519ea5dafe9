// busy [leak | race | undefined]: publishes, hears, serves, calls, acts, sets parameters and times, in several
// threads, until it is interrupted; in between nodes come and go. With a word it does something wrong instead.

#include <dlfcn.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <thread>

#include "example_interfaces/action/fibonacci.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"

using namespace std::chrono_literals;
using example_interfaces::action::Fibonacci;
using std_msgs::msg::String;
using std_srvs::srv::Trigger;

class Busy : public rclcpp::Node
{
public:
  Busy()
  : Node("busy")
  {
    declare_parameter("count", 0);
    told_ = add_post_set_parameters_callback([this](const auto &) {++changes_;});
    group_ = create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    publisher_ = create_publisher<String>("chatter", 100);
    rclcpp::SubscriptionOptions options;
    options.callback_group = group_;
    subscription_ = create_subscription<String>(
      "chatter", 100, [this](String::UniquePtr message) {characters_ += message->data.size();}, options);
    service_ = create_service<Trigger>(
      "go", [](const Trigger::Request::SharedPtr, Trigger::Response::SharedPtr response) {
        response->message = "gone";
      }, rclcpp::ServicesQoS(), group_);
    client_ = create_client<Trigger>("go", rclcpp::ServicesQoS(), group_);
    act();
    fast_ = create_wall_timer(2ms, [this]() {publish();}, group_);
    slow_ = create_timer(10ms, [this]() {call();});
    passing_ = create_wall_timer(200ms, [this]() {let_one_pass();}, group_);
    goals_ = create_wall_timer(10ms, [this]() {send_goal();}, group_);
  }

  void report() const
  {
    std::printf(
      "characters %d answers %d changes %d passed %d results %d\n", characters_ > 0, answers_ > 0,
      changes_ > 0, passed_ > 0, results_ > 0);
  }

private:
  void publish()
  {
    String message;
    message.data = std::to_string(get_parameter("count").as_int());
    publisher_->publish(message);
    RCLCPP_INFO_THROTTLE(get_logger(), *get_clock(), 1000, "published %s", message.data.c_str());
  }

  void call()
  {
    set_parameter({"count", ++calls_});
    if (!client_->service_is_ready()) {
      return;
    }
    const auto sent = client_->async_send_request(
      std::make_shared<Trigger::Request>(),
      [this](rclcpp::Client<Trigger>::SharedFuture future) {
        answers_ += static_cast<int>(future.get()->message.size());
      });
    if (calls_ % 10 == 0) {
      client_->remove_pending_request(sent);
    }
  }

  /// Goals of even orders are let go, which cancels them.
  void act()
  {
    using Handle = std::shared_ptr<rclcpp_action::ServerGoalHandle<Fibonacci>>;
    auto options = rcl_action_server_get_default_options();
    options.result_timeout.nanoseconds = RCL_MS_TO_NS(100);
    action_server_ = rclcpp_action::create_server<Fibonacci>(
      this, "fibonacci", [](const auto &, auto) {return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;},
      [](const auto &) {return rclcpp_action::CancelResponse::ACCEPT;},
      [](const Handle & handle) {
        handle->publish_feedback(std::make_shared<Fibonacci::Feedback>());
        if (handle->get_goal()->order % 2 == 1) {
          std::thread([handle]() {end(*handle);}).join();
        }
      }, options, group_);
    action_client_ = rclcpp_action::create_client<Fibonacci>(this, "fibonacci", group_);
  }

  /// The context may have ended.
  static void end(rclcpp_action::ServerGoalHandle<Fibonacci> & handle)
  {
    try {
      handle.succeed(std::make_shared<Fibonacci::Result>());
    } catch (const rclcpp::exceptions::RCLError &) {
      if (rclcpp::ok()) {
        throw;
      }
    }
  }

  void send_goal()
  {
    if (!action_client_->action_server_is_ready()) {
      return;
    }
    using Client = rclcpp_action::Client<Fibonacci>;
    Client::SendGoalOptions options;
    options.feedback_callback = [](auto, auto) {};
    options.result_callback = [this](const Client::WrappedResult &) {++results_;};
    Fibonacci::Goal goal;
    goal.order = ++sent_goals_;
    action_client_->async_send_goal(goal, options);
    if (goal.order % 10 == 0) {
      action_client_->async_cancel_all_goals();
    }
  }

  void let_one_pass()
  {
    try {
      // Several may be here at the same time, two of each name.
      const std::string name = "passing_" + std::to_string(++names_);
      auto node = std::make_shared<rclcpp::Node>(name);
      auto other = std::make_shared<rclcpp::Node>(name);
      auto publisher = node->create_publisher<String>("chatter", 1);
      publisher->publish(String());
      rclcpp::spin_some(node);
      const auto fleeting = create_wall_timer(1ms, []() {}, group_);  // while others collect what is in it
      RCLCPP_DEBUG(other->get_logger().get_child("child"), "gone again");
      ++passed_;
    } catch (const rclcpp::exceptions::RCLError &) {
      if (rclcpp::ok()) {
        throw;
      }
    }
  }

  std::atomic<std::size_t> characters_{0};
  std::atomic_int answers_{0}, changes_{0}, passed_{0}, names_{0}, results_{0}, sent_goals_{0};
  int calls_ = 0;
  rclcpp::CallbackGroup::SharedPtr group_;
  PostSetParametersCallbackHandle::SharedPtr told_;
  rclcpp::Publisher<String>::SharedPtr publisher_;
  rclcpp::Subscription<String>::SharedPtr subscription_;
  rclcpp::Service<Trigger>::SharedPtr service_;
  rclcpp::Client<Trigger>::SharedPtr client_;
  rclcpp::TimerBase::SharedPtr fast_, slow_, passing_, goals_;
  rclcpp_action::Server<Fibonacci>::SharedPtr action_server_;
  rclcpp_action::Client<Fibonacci>::SharedPtr action_client_;
};

/// Where the rclcpp lies that this program uses.
const char * place_of_rclcpp()
{
  Dl_info found{};
  bool (* const function)(rclcpp::Context::SharedPtr) = &rclcpp::ok;
  return dladdr(reinterpret_cast<const void *>(function), &found) != 0 ? found.dli_fname : "nowhere";
}

void leak()
{
  rclcpp::Node node("leaky");
  auto publisher = node.create_publisher<String>("chatter", 1);
  for (int i = 0; i < 10; ++i) {
    publisher->publish(*std::make_unique<String>().release());
  }
}

void race()
{
  int number = 0;
  const auto count = [&number]() {
      for (int i = 0; i < 1000; ++i) {
        ++number;
      }
    };
  std::thread one(count), other(count);
  one.join();
  other.join();
  std::printf("%d\n", number);
}

void overflow(int number)
{
  std::printf("%d\n", std::numeric_limits<int>::max() - 1 + number);
}

void be_busy()
{
  auto node = std::make_shared<Busy>();
  rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 4);
  executor.add_node(node);
  executor.spin();
  node->report();
}

int main(int argc, char * argv[])
{
  const std::string wrong = argc > 1 ? argv[1] : "";
  rclcpp::init(argc, argv);
  std::printf("rclcpp: %s\n", place_of_rclcpp());
  std::fflush(stdout);
  if (wrong == "leak") {
    leak();
  } else if (wrong == "race") {
    race();
  } else if (wrong == "undefined") {
    overflow(argc);
  } else {
    be_busy();
  }
  rclcpp::shutdown();
  return 0;
}
