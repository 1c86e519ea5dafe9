// floor both|say|hear SECONDS: does the same as node.cpp with rcl's own functions, and nothing unnecessary.

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "rcl/rcl.h"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int64.hpp"

using std_msgs::msg::Int64;
using Steady = std::chrono::steady_clock;

constexpr std::int64_t burst = 100;

void check(rcl_ret_t ret)
{
  if (ret != RCL_RET_OK) {
    rclcpp::exceptions::throw_from_rcl_error(ret);
  }
}

const rosidl_message_type_support_t * type()
{
  return rosidl_typesupport_cpp::get_message_type_support_handle<Int64>();
}

/// A publisher and a subscription of one node.
struct Side
{
  rcl_node_t node = rcl_get_zero_initialized_node();
  rcl_publisher_t publisher = rcl_get_zero_initialized_publisher();
  rcl_subscription_t subscription = rcl_get_zero_initialized_subscription();

  void begin(rcl_context_t & context, const char * name, const char * says, const char * hears)
  {
    const rcl_node_options_t options = rcl_node_get_default_options();
    check(rcl_node_init(&node, name, "", &context, &options));
    rcl_publisher_options_t publishing = rcl_publisher_get_default_options();
    publishing.qos.depth = 1000;
    check(rcl_publisher_init(&publisher, &node, type(), says, &publishing));
    rcl_subscription_options_t subscribing = rcl_subscription_get_default_options();
    subscribing.qos.depth = 1000;
    check(rcl_subscription_init(&subscription, &node, type(), hears, &subscribing));
  }

  void end()
  {
    check(rcl_publisher_fini(&publisher, &node));
    check(rcl_subscription_fini(&subscription, &node));
    check(rcl_node_fini(&node));
  }

  bool is_matched()
  {
    std::size_t listeners = 0, sayers = 0;
    check(rcl_publisher_get_subscription_count(&publisher, &listeners));
    check(rcl_subscription_get_publisher_count(&subscription, &sayers));
    return listeners > 0 && sayers > 0;
  }

  void say(std::int64_t first, std::int64_t count)
  {
    Int64 message;
    for (message.data = first; message.data < first + count; ++message.data) {
      check(rcl_publish(&publisher, &message, nullptr));
    }
  }
};

void add(rcl_wait_set_t & set, const Side & side)
{
  check(rcl_wait_set_add_subscription(&set, &side.subscription, nullptr));
}

bool take(Side & side, Int64 & message)
{
  rmw_message_info_t info;
  return rcl_take(&side.subscription, &message, &info, nullptr) == RCL_RET_OK;
}

int main(int argc, char * argv[])
{
  const std::string role = argv[1];
  const bool says = role != "hear", hears = role != "say";
  const double seconds = std::atof(argv[2]);
  rcl_init_options_t options = rcl_get_zero_initialized_init_options();
  check(rcl_init_options_init(&options, rcl_get_default_allocator()));
  rcl_context_t context = rcl_get_zero_initialized_context();
  check(rcl_init(argc, argv, &options, &context));
  Side sayer, hearer;
  if (says) {
    sayer.begin(context, "sayer", "numbers", "thanks");
  }
  if (hears) {
    hearer.begin(context, "hearer", "thanks", "numbers");
  }
  rcl_wait_set_t set = rcl_get_zero_initialized_wait_set();
  check(rcl_wait_set_init(&set, 2, 0, 0, 0, 0, 0, &context, rcl_get_default_allocator()));
  std::int64_t sent = 0;
  Steady::time_point began;
  for (bool goes_on = true; goes_on; ) {
    check(rcl_wait_set_clear(&set));
    if (says) {
      add(set, sayer);
    }
    if (hears) {
      add(set, hearer);
    }
    const rcl_ret_t waited = rcl_wait(&set, RCL_MS_TO_NS(10));
    if (waited != RCL_RET_TIMEOUT) {
      check(waited);
    }
    Int64 message;
    if (hears && take(hearer, message) && (message.data + 1) % burst == 0) {
      hearer.say(message.data, 1);
    }
    if (says && sent == 0 && sayer.is_matched()) {
      began = Steady::now();
      sayer.say(sent, burst);
      sent += burst;
    }
    if (says && take(sayer, message)) {
      const std::chrono::duration<double> passed = Steady::now() - began;
      goes_on = passed.count() < seconds;
      if (goes_on) {
        sayer.say(sent, burst);
        sent += burst;
      } else {
        std::printf("%.0f\n", static_cast<double>(sent) / passed.count());
      }
    }
  }
  check(rcl_wait_set_fini(&set));
  if (says) {
    sayer.end();
  }
  if (hears) {
    hearer.end();
  }
  check(rcl_shutdown(&context));
  check(rcl_context_fini(&context));
  check(rcl_init_options_fini(&options));
  return 0;
}
