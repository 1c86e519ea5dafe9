// signals spin | own | loop | sleep | callbacks | failing | nested | throw: what a signal ends, and how.

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;

std::atomic_bool kill_this_process{false};

void own_handler(int)
{
  kill_this_process = true;
}

void say(const char * text)
{
  std::puts(text);
  std::fflush(stdout);
}

/// A loop of the program's own, with its own handler, as robot drivers have it.
void loop_until_killed()
{
  std::signal(SIGINT, own_handler);
  auto node = std::make_shared<rclcpp::Node>("own");
  say("ready");
  rclcpp::WallRate rate(200.0);
  while (!kill_this_process) {
    rclcpp::spin_some(node);
    rate.sleep();
  }
  say(rclcpp::ok() ? "still ok" : "not ok");
}

int main(int argc, char * argv[])
{
  const std::string what = argv[1];
  const auto handled =
    what == "own" ? rclcpp::SignalHandlerOptions::None : rclcpp::SignalHandlerOptions::All;
  rclcpp::init(argc, argv, rclcpp::InitOptions(), handled);
  if (what == "own") {
    loop_until_killed();
  } else if (what == "loop") {
    auto node = std::make_shared<rclcpp::Node>("loop");
    say("ready");
    rclcpp::Rate rate(200.0);
    while (rclcpp::ok()) {
      rclcpp::spin_some(node);
      rate.sleep();
    }
    say("left");
  } else if (what == "sleep") {
    say("ready");
    say(rclcpp::sleep_for(1h) ? "slept" : "woken");
  } else if (what == "callbacks") {
    rclcpp::on_shutdown([]() {say("on shutdown"); rclcpp::shutdown();});
    auto node = std::make_shared<rclcpp::Node>("callbacks");
    say("ready");
    rclcpp::spin(node);
    say("left");
  } else if (what == "failing") {
    rclcpp::on_shutdown([]() {throw std::runtime_error("on purpose");});
    auto node = std::make_shared<rclcpp::Node>("failing");
    say("ready");
    rclcpp::spin(node);
    say("left");
  } else if (what == "nested") {
    // The thread that hears of the signal waits for the shutdown, whose callback asks for another one.
    rclcpp::on_shutdown([]() {std::raise(SIGINT); rclcpp::shutdown();});
    rclcpp::shutdown();
    say("left");
  } else if (what == "throw") {
    auto node = std::make_shared<rclcpp::Node>("throw");
    auto timer = node->create_wall_timer(1ms, []() {throw std::runtime_error("from a callback");});
    try {
      rclcpp::spin(node);
    } catch (const std::runtime_error & error) {
      say(error.what());
    }
    return 5;  // without a shutdown: the program just ends
  } else {
    auto node = std::make_shared<rclcpp::Node>("spin");
    auto timer = node->create_wall_timer(1ms, []() {});
    say("ready");
    rclcpp::spin(node);
    say("left");
  }
  rclcpp::shutdown();
  return 0;
}
