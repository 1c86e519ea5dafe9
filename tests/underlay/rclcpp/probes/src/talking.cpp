// talking say COUNT | hear | late | quiet: one side of a topic, the other one is rclpy's.

#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
using std_msgs::msg::String;

/// Publishes numbers, by reference and by unique pointer in turn, once somebody listens.
class Sayer : public rclcpp::Node
{
public:
  explicit Sayer(int count)
  : Node("sayer"), count_(count)
  {
    // Keeps them all for a listener that is known here before it knows this publisher.
    publisher_ = create_publisher<String>("chatter", rclcpp::QoS(100).transient_local());
    timer_ = create_wall_timer(5ms, std::bind(&Sayer::say, this));
  }

private:
  void say()
  {
    if (publisher_->get_subscription_count() == 0 || next_ == count_) {
      return;
    }
    String message;
    message.data = std::to_string(next_++);
    if (next_ % 2 == 0) {
      publisher_->publish(message);
    } else {
      publisher_->publish(std::make_unique<String>(message));
    }
  }

  int count_, next_ = 0;
  rclcpp::Publisher<String>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

/// Logs what it hears, with callbacks of all forms.
class Hearer : public rclcpp::Node
{
public:
  Hearer()
  : Node("hearer")
  {
    using std::placeholders::_1;
    using std::placeholders::_2;
    subscribe([this](const String & message) {heard("reference", message);});
    subscribe([this](const auto & message) {heard("generic", message);});
    subscribe([this](String message) {heard("value", message);});
    subscribe([this](String::SharedPtr message) {heard("shared", *message);});
    subscribe([this](const String::ConstSharedPtr message) {heard("shared_const", *message);});
    subscribe([this](const std::shared_ptr<const String> & message) {heard("const_reference", *message);});
    subscribe([this](std::unique_ptr<String> message) {heard("unique", *message);});
    subscribe(
      [this](const String & message, const rclcpp::MessageInfo & info) {with("info", message, info);});
    subscribe(
      [this](String::UniquePtr message, const rclcpp::MessageInfo & info) {
        with("unique_info", *message, info);
      });
    subscribe(std::function<void(String::SharedPtr)>([this](auto message) {heard("function", *message);}));
    subscribe(std::bind(&Hearer::heard_shared, this, _1));
    subscribe(std::bind(&Hearer::heard, this, "bound_reference", _1));
    subscribe(std::bind(&Hearer::with, this, "bound_info", _1, _2));
  }

private:
  template<typename Callback>
  void subscribe(Callback && callback)
  {
    subscriptions_.push_back(
      create_subscription<String>("chatter", rclcpp::QoS(10), std::forward<Callback>(callback)));
  }
  void heard(const char * form, const String & message) const
  {
    RCLCPP_INFO(get_logger(), "heard %s by %s", message.data.c_str(), form);
  }
  void heard_shared(const String::SharedPtr message) const {heard("bound", *message);}
  void with(const char * form, const String & message, const rclcpp::MessageInfo & info) const
  {
    if (info.get_rmw_message_info().source_timestamp > 0) {
      heard(form, message);
    }
  }

  std::vector<rclcpp::Subscription<String>::SharedPtr> subscriptions_;
};

int main(int argc, char * argv[])
{
  const auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  const std::string & what = words.at(1);
  if (what == "say") {
    rclcpp::spin(std::make_shared<Sayer>(std::atoi(words.at(2).c_str())));
  } else if (what == "hear") {
    rclcpp::spin(std::make_shared<Hearer>());
  } else {
    // late: one message, before anybody listens; quiet: a publisher that not everybody can listen to
    auto node = std::make_shared<rclcpp::Node>("sayer");
    const auto qos = what == "late" ? rclcpp::QoS(1).transient_local() : rclcpp::QoS(1).best_effort();
    auto publisher = node->create_publisher<String>("chatter", qos);
    String message;
    message.data = "kept";
    publisher->publish(message);
    RCLCPP_INFO(node->get_logger(), "published");
    rclcpp::spin(node);
  }
  rclcpp::shutdown();
  return 0;
}
