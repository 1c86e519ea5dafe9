// Publishes, hears, serves, calls, sets parameters and times, in several threads, until it is interrupted.
// In between nodes come and go.

#include <atomic>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"

using namespace std::chrono_literals;
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
    fast_ = create_wall_timer(1ms, [this]() {publish();}, group_);
    slow_ = create_timer(10ms, [this]() {call();});
    passing_ = create_wall_timer(100ms, [this]() {let_one_pass();}, group_);
  }

  void report() const
  {
    std::printf(
      "characters %d answers %d changes %d passed %d\n", characters_ > 0, answers_ > 0, changes_ > 0,
      passed_ > 0);
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
    if (client_->service_is_ready()) {
      client_->async_send_request(
        std::make_shared<Trigger::Request>(),
        [this](rclcpp::Client<Trigger>::SharedFuture future) {
          answers_ += static_cast<int>(future.get()->message.size());
        });
    }
  }

  void let_one_pass()
  {
    try {
      // Several may be here at the same time: names are not shared.
      auto node = std::make_shared<rclcpp::Node>("passing_" + std::to_string(++names_));
      auto publisher = node->create_publisher<String>("chatter", 1);
      publisher->publish(String());
      rclcpp::spin_some(node);
      RCLCPP_DEBUG(node->get_logger().get_child("child"), "gone again");
      ++passed_;
    } catch (const rclcpp::exceptions::RCLError &) {
      if (rclcpp::ok()) {
        throw;
      }
    }
  }

  std::atomic<std::size_t> characters_{0};
  std::atomic_int answers_{0}, changes_{0}, passed_{0}, names_{0};
  int calls_ = 0;
  rclcpp::CallbackGroup::SharedPtr group_;
  PostSetParametersCallbackHandle::SharedPtr told_;
  rclcpp::Publisher<String>::SharedPtr publisher_;
  rclcpp::Subscription<String>::SharedPtr subscription_;
  rclcpp::Service<Trigger>::SharedPtr service_;
  rclcpp::Client<Trigger>::SharedPtr client_;
  rclcpp::TimerBase::SharedPtr fast_, slow_, passing_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Busy>();
  rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 4);
  executor.add_node(node);
  executor.spin();
  node->report();
  rclcpp::shutdown();
  return 0;
}
