// node both|say|hear SECONDS: sends bursts of messages, each after the hearer has confirmed the one before.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int64.hpp"

using std_msgs::msg::Int64;
using Steady = std::chrono::steady_clock;

constexpr int burst = 100;

class Sayer : public rclcpp::Node
{
public:
  explicit Sayer(double seconds)
  : Node("sayer"), seconds_(seconds)
  {
    publisher_ = create_publisher<Int64>("numbers", 1000);
    subscription_ =
      create_subscription<Int64>("thanks", 10, [this](const Int64 &) {thanked();});
    begin_ = create_wall_timer(
      std::chrono::milliseconds(10), [this]() {
        if (publisher_->get_subscription_count() > 0 && subscription_->get_publisher_count() > 0) {
          begin_->cancel();
          began_ = Steady::now();
          say();
        }
      });
  }

private:
  void say()
  {
    Int64 message;
    for (int i = 0; i < burst; ++i) {
      message.data = sent_++;
      publisher_->publish(message);
    }
  }

  void thanked()
  {
    const std::chrono::duration<double> passed = Steady::now() - began_;
    if (passed.count() < seconds_) {
      say();
      return;
    }
    std::printf("%.0f\n", static_cast<double>(sent_) / passed.count());
    rclcpp::shutdown();
  }

  double seconds_;
  std::int64_t sent_ = 0;
  Steady::time_point began_;
  rclcpp::Publisher<Int64>::SharedPtr publisher_;
  rclcpp::Subscription<Int64>::SharedPtr subscription_;
  rclcpp::TimerBase::SharedPtr begin_;
};

class Hearer : public rclcpp::Node
{
public:
  Hearer()
  : Node("hearer")
  {
    publisher_ = create_publisher<Int64>("thanks", 10);
    subscription_ = create_subscription<Int64>(
      "numbers", 1000, [this](const Int64 & message) {
        if ((message.data + 1) % burst == 0) {
          publisher_->publish(message);
        }
      });
  }

private:
  rclcpp::Publisher<Int64>::SharedPtr publisher_;
  rclcpp::Subscription<Int64>::SharedPtr subscription_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const std::string role = argv[1];
  rclcpp::executors::SingleThreadedExecutor executor;
  rclcpp::Node::SharedPtr sayer, hearer;
  if (role != "hear") {
    sayer = std::make_shared<Sayer>(std::atof(argv[2]));
    executor.add_node(sayer);
  }
  if (role != "say") {
    hearer = std::make_shared<Hearer>();
    executor.add_node(hearer);
  }
  executor.spin();
  rclcpp::shutdown();
  return 0;
}
