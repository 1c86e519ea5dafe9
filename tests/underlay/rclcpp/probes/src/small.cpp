// small CASE: small functions of all parts; 0 when it holds.

#include "rclcpp/rclcpp.hpp"

#include <filesystem>
#include <fstream>

#include "case.hpp"
#include "rclcpp/copy_all_parameter_values.hpp"
#include "rclcpp/expand_topic_or_service_name.hpp"
#include "rclcpp/node_interfaces/node_interfaces.hpp"
#include "rclcpp/parameter_map.hpp"
#include "rclcpp/time_source.hpp"
#include "rosgraph_msgs/msg/clock.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"

using namespace std::chrono_literals;
using std_msgs::msg::String;
using std_srvs::srv::Trigger;
namespace exceptions = rclcpp::exceptions;
namespace parts = rclcpp::node_interfaces;

namespace
{

std::shared_ptr<rclcpp::Node> node()
{
  return std::make_shared<rclcpp::Node>("node");
}

void times_of_messages()
{
  builtin_interfaces::msg::Time time;
  time.sec = 1;
  time.nanosec = 500000000;
  const auto later = time + rclcpp::Duration(1, 600000000), earlier = time - rclcpp::Duration(1, 0);
  EXPECT(later.sec == 3 && later.nanosec == 100000000);
  EXPECT(earlier.sec == 0 && earlier.nanosec == 500000000);
  EXPECT(!THROWN(std::overflow_error, time + rclcpp::Duration::from_nanoseconds(INT64_MAX)).empty());
  time.sec = -1;
  EXPECT(THROWN(std::runtime_error, time + rclcpp::Duration(1, 0)) == "message time is negative");
}

void rates()
{
  EXPECT(!rclcpp::Rate(10.0).is_steady() && rclcpp::WallRate(10.0).is_steady());
  rclcpp::GenericRate<std::chrono::steady_clock> rate(50ms);
  EXPECT(rate.is_steady() && rate.period() == 50ms && rate.get_type() == RCL_STEADY_TIME);
  EXPECT(!rclcpp::GenericRate<std::chrono::system_clock>(10.0).is_steady());
  const auto began = std::chrono::steady_clock::now();
  rate.reset();
  EXPECT(rate.sleep() && std::chrono::steady_clock::now() - began >= 49ms);
}

void where_logs_go()
{
  EXPECT(rclcpp::get_logging_directory().is_absolute());
  EXPECT(rclcpp::NodeOptions(rcl_get_default_allocator()).allocator().allocate != nullptr);
  EXPECT(exceptions::InvalidNodeError().what() == std::string("node is invalid"));
}

void a_sleep_that_is_cancelled()
{
  for (const auto type : {RCL_SYSTEM_TIME, RCL_STEADY_TIME, RCL_ROS_TIME}) {
    rclcpp::Clock clock(type);
    std::atomic<bool> result{true}, is_over{false};
    std::thread sleeping([&]() {
        result = clock.sleep_for(rclcpp::Duration(3600, 0));
        is_over = true;
      });
    std::this_thread::sleep_for(50ms);
    EXPECT(!is_over);
    clock.cancel_sleep_or_wait();
    sleeping.join();
    EXPECT(!result);
    clock.cancel_sleep_or_wait();
    EXPECT(!clock.sleep_for(rclcpp::Duration(3600, 0)));  // the next one, where nobody slept
    EXPECT(clock.sleep_for(rclcpp::Duration(0, 1000)));
  }
}

/// One clock's sleep ends, and nobody else's.
void others_sleep_on()
{
  rclcpp::Clock one, other;
  const auto began = std::chrono::steady_clock::now();
  std::thread first([&]() {EXPECT(!one.sleep_for(rclcpp::Duration(3600, 0)));});
  std::thread second([&]() {EXPECT(other.sleep_for(rclcpp::Duration(0, 300000000)));});
  std::this_thread::sleep_for(50ms);
  one.cancel_sleep_or_wait();
  first.join();
  second.join();
  EXPECT(std::chrono::steady_clock::now() - began >= 299ms);
}

void what_timers_tell()
{
  auto here = node();
  rclcpp::TimerInfo told;
  int resets = 0;
  auto timer = here->create_wall_timer(20ms, [&](const rclcpp::TimerInfo & info) {told = info;});
  timer->set_on_reset_callback([&](std::size_t count) {resets += static_cast<int>(count);});
  timer->reset();
  EXPECT(resets == 1);
  timer->clear_on_reset_callback();
  timer->reset();
  EXPECT(resets == 1);
  EXPECT(!THROWN(std::invalid_argument, timer->set_on_reset_callback(nullptr)).empty());
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(here);
  const auto limit = std::chrono::steady_clock::now() + 60s;
  while (told.actual_call_time.nanoseconds() == 0) {
    EXPECT(std::chrono::steady_clock::now() < limit);
    executor.spin_once(10ms);
  }
  EXPECT(told.expected_call_time.nanoseconds() > 0 && told.actual_call_time >= told.expected_call_time);
  EXPECT(told.actual_call_time.get_clock_type() == RCL_STEADY_TIME);
}

void a_timer_that_is_called()
{
  rclcpp::TimerInfo told;
  int calls = 0;
  auto timer = node()->create_wall_timer(1ms, [&](const rclcpp::TimerInfo & info) {
        told = info;
        ++calls;
      });
  const auto first = timer->call();
  std::this_thread::sleep_for(2ms);
  const auto second = timer->call();
  EXPECT(first && second && calls == 0);
  timer->execute_callback(second);
  const auto late = told.actual_call_time;
  timer->execute_callback(first);
  EXPECT(calls == 2 && told.actual_call_time < late);
  timer->cancel();
  EXPECT(!timer->call());
}

void where_packets_go()
{
  auto here = node();
  const auto publisher = here->create_publisher<String>("topic", 10);
  const auto subscription = here->create_subscription<String>("topic", 10, [](const String &) {});
  EXPECT(!publisher->get_network_flow_endpoints().empty());
  const auto common = subscription->get_network_flow_endpoints().back();  // shared memory comes before it
  EXPECT(common.transport_protocol() == "UDP" && common.internet_protocol() == "IPv4");
  EXPECT(common.transport_port() != 0 && !common.internet_address().empty());
  EXPECT(common == subscription->get_network_flow_endpoints().back());
  rclcpp::SubscriptionOptions options;
  options.require_unique_network_flow_endpoints = RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_STRICTLY_REQUIRED;
  const auto other = here->create_subscription<String>("topic", 10, [](const String &) {}, options);
  const auto own = other->get_network_flow_endpoints().back();
  EXPECT(own != common && own.transport_port() != common.transport_port());
  rclcpp::PublisherOptions same;
  same.require_unique_network_flow_endpoints = RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_STRICTLY_REQUIRED;
  // This middleware has none for publishers, so that the wish has come to it is known by the error.
  EXPECT(!THROWN(exceptions::RCLError, here->create_publisher<String>("topic", 10, same)).empty());
  std::ostringstream text;
  text << own;
  EXPECT(text.str().rfind("{\"transportProtocol\": \"UDP\", \"internetProtocol\": \"IPv4\", ", 0) == 0);
  const auto port = "\"transportPort\": \"" + std::to_string(own.transport_port()) + "\", ";
  EXPECT(text.str().find(port) != std::string::npos);
  EXPECT(text.str().find("\"internetAddress\": \"" + own.internet_address() + "\"}") != std::string::npos);
}

void what_is_told_of_new_things()
{
  auto here = node();
  std::atomic<std::size_t> messages{0}, requests{0}, responses{0};
  auto publisher = here->create_publisher<String>("topic", 10);
  auto subscription = here->create_subscription<String>("topic", 10, [](const String &) {});
  auto service = here->create_service<Trigger>(
    "go", [](const Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) {});
  auto client = here->create_client<Trigger>("go");
  EXPECT(client->wait_for_service(60s));
  subscription->set_on_new_message_callback([&](std::size_t count) {messages += count;});
  service->set_on_new_request_callback([&](std::size_t count) {requests += count;});
  client->set_on_new_response_callback([&](std::size_t count) {responses += count;});
  wait_until([&]() {return publisher->get_subscription_count() == 1;});
  publisher->publish(String());
  publisher->publish(String());
  auto future = client->async_send_request(std::make_shared<Trigger::Request>());
  wait_until([&]() {return messages == 2 && requests == 1;});
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(here);
  EXPECT(executor.spin_until_future_complete(future, 60s) == rclcpp::FutureReturnCode::SUCCESS);
  wait_until([&]() {return responses == 1;});
  subscription->clear_on_new_message_callback();
  publisher->publish(String());
  subscription->set_on_new_message_callback([](std::size_t) {throw std::runtime_error("is only logged");});
  publisher->publish(String());
  executor.spin_some();
  EXPECT(messages == 2);
  EXPECT(
    THROWN(std::invalid_argument, subscription->set_on_new_message_callback(nullptr)) ==
    "The callback passed to set_on_new_message_callback is not callable.");
}

void handles_of_what_is_constant()
{
  auto here = node();
  const auto publisher = here->create_publisher<String>("topic", 10);
  const auto subscription = here->create_subscription<String>("topic", 10, [](const String &) {});
  const auto client = here->create_client<Trigger>("go");
  const rclcpp::PublisherBase & constant = *publisher;
  std::shared_ptr<const rcl_publisher_t> handle = constant.get_publisher_handle();
  EXPECT(handle == publisher->get_publisher_handle());
  EXPECT(std::as_const(*subscription).get_subscription_handle() && std::as_const(*client).get_client_handle());
}

void made_of_parts_of_a_node()
{
  auto here = node();
  const parts::NodeInterfaces<
    parts::NodeBaseInterface, parts::NodeServicesInterface, parts::NodeTimersInterface,
    parts::NodeGraphInterface, parts::NodeClockInterface, parts::NodeLoggingInterface,
    parts::NodeTopicsInterface> some(*here);
  EXPECT(some.get_node_base_interface() == here->get_node_base_interface());
  EXPECT(some.get<parts::NodeTopicsInterface>() == here->get_node_topics_interface());
  const parts::NodeInterfaces<parts::NodeBaseInterface, parts::NodeLoggingInterface> fewer(some);
  EXPECT(fewer.get_node_base_interface()->get_name() == std::string("node"));
  const auto base = some.get_node_base_interface();
  const auto services = some.get_node_services_interface();
  auto service = rclcpp::create_service<Trigger>(
    base, services, "go", [](const Trigger::Request::SharedPtr, Trigger::Response::SharedPtr response) {
      response->success = true;
    }, rclcpp::ServicesQoS(), nullptr);
  auto client = rclcpp::create_client<Trigger>(base, some.get_node_graph_interface(), services, "go");
  int calls = 0;
  const auto count = [&]() {++calls;};
  auto first = rclcpp::create_timer(
    base, some.get_node_timers_interface(), here->get_clock(), rclcpp::Duration(1ms), count);
  auto second = rclcpp::create_timer(
    here->get_clock(), 1ms, count, nullptr, base.get(), some.get_node_timers_interface().get());
  EXPECT(client->wait_for_service(60s));
  auto future = client->async_send_request(std::make_shared<Trigger::Request>());
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(base);
  EXPECT(executor.spin_until_future_complete(future, 60s) == rclcpp::FutureReturnCode::SUCCESS);
  EXPECT(future.get()->success);
  while (calls < 4) {
    executor.spin_once(60s);
  }
}

void names_in_full()
{
  using rclcpp::expand_topic_or_service_name;
  EXPECT(expand_topic_or_service_name("chatter", "node", "/space") == "/space/chatter");
  EXPECT(expand_topic_or_service_name("~/chatter", "node", "/space", true) == "/space/node/chatter");
  EXPECT(expand_topic_or_service_name("{node}/x", "node", "/") == "/node/x");
  EXPECT(!THROWN(exceptions::InvalidTopicNameError, expand_topic_or_service_name("a?", "n", "/")).empty());
  EXPECT(
    !THROWN(exceptions::InvalidServiceNameError, expand_topic_or_service_name("a?", "n", "/", true)).empty());
  EXPECT(!THROWN(exceptions::InvalidNodeNameError, expand_topic_or_service_name("a", "n?", "/")).empty());
  EXPECT(!THROWN(exceptions::InvalidNamespaceError, expand_topic_or_service_name("a", "n", "/s?")).empty());
}

void clocks_that_follow_a_topic()
{
  const auto here = node();
  const auto clock = std::make_shared<rclcpp::Clock>(RCL_ROS_TIME);
  const auto steady = std::make_shared<rclcpp::Clock>(RCL_STEADY_TIME);
  rclcpp::TimeSource source(here);
  source.attachClock(clock);
  EXPECT(!clock->ros_time_is_active());
  here->set_parameter(rclcpp::Parameter("use_sim_time", true));
  EXPECT(clock->ros_time_is_active() && source.clock_thread_is_joinable());
  EXPECT(!THROWN(std::invalid_argument, source.attachClock(steady)).empty());
  const auto publisher = here->create_publisher<rosgraph_msgs::msg::Clock>("/clock", 1);
  rosgraph_msgs::msg::Clock message;
  message.clock.sec = 42;
  wait_until([&]() {
      publisher->publish(message);
      return clock->now().seconds() == 42.0;
    });
  source.detachClock(clock);
  message.clock.sec = 43;
  wait_until([&]() {
      publisher->publish(message);
      return here->now().seconds() == 43.0;
    });
  EXPECT(clock->now().seconds() == 42.0);
  source.attachClock(clock);
  wait_until([&]() {  // the node and the source hear it one after the other
      publisher->publish(message);
      return clock->now().seconds() == 43.0;
    });
  here->set_parameter(rclcpp::Parameter("use_sim_time", false));
  EXPECT(!clock->ros_time_is_active());
  source.attachClock(steady);
  EXPECT(!here->set_parameter(rclcpp::Parameter("use_sim_time", true)).successful);
}

void parameters_of_a_file()
{
  const std::string file = std::filesystem::temp_directory_path() / "parameters_of_a_file.yaml";
  std::ofstream(file) << "/node:\n  ros__parameters:\n    speed: 0.5\n    names: [a, b]\n"
                      << "/other:\n  ros__parameters:\n    speed: 2.0\n";
  const auto every = rclcpp::parameter_map_from_yaml_file(file);
  EXPECT(every.size() == 2 && every.at("/other").front().as_double() == 2.0);
  const auto own = rclcpp::parameters_from_map(every, "/node");
  EXPECT(own.size() == 2 && rclcpp::parameter_map_from_yaml_file(file, "/node").size() == 1);
  EXPECT(!THROWN(exceptions::RCLError, rclcpp::parameter_map_from_yaml_file(file + "x")).empty());

  const auto here = node();
  here->declare_parameter("speed", 0.0);
  here->declare_parameter("names", std::vector<std::string>{});
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(here);
  const auto asking = std::make_shared<rclcpp::Node>("asking");
  executor.add_node(asking);
  rclcpp::AsyncParametersClient client(asking, "node");
  EXPECT(client.wait_for_service(60s));
  auto future = client.load_parameters(file);
  EXPECT(executor.spin_until_future_complete(future, 60s) == rclcpp::FutureReturnCode::SUCCESS);
  EXPECT(here->get_parameter("speed").as_double() == 0.5);
  EXPECT(here->get_parameter("names").as_string_array().back() == "b");
  rclcpp::AsyncParametersClient stranger(asking, "stranger");
  EXPECT(!THROWN(exceptions::InvalidParametersException, stranger.load_parameters(file)).empty());
  std::filesystem::remove(file);

  const auto copy = std::make_shared<rclcpp::Node>("copy");
  copy->declare_parameter("speed", 3.0);
  rclcpp::copy_all_parameter_values(here, copy);
  EXPECT(copy->get_parameter("speed").as_double() == 3.0 && copy->has_parameter("names"));
  rclcpp::copy_all_parameter_values(here, copy, true);
  EXPECT(copy->get_parameter("speed").as_double() == 0.5);
}

void timers_made_by_their_class()
{
  const auto here = node();
  int calls = 0;
  const auto count = [&]() {++calls;};
  const auto timer = rclcpp::WallTimer<decltype(count)>::make_shared(1ms, count);
  here->get_node_timers_interface()->add_timer(timer, nullptr);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(here);
  while (calls < 3) {
    executor.spin_once(60s);
  }
  timer->cancel();
  EXPECT(timer->is_canceled() && timer->is_steady());
}

}  // namespace

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const Cases cases{
    {"times_of_messages", times_of_messages},
    {"rates", rates},
    {"where_logs_go", where_logs_go},
    {"a_sleep_that_is_cancelled", a_sleep_that_is_cancelled},
    {"others_sleep_on", others_sleep_on},
    {"what_timers_tell", what_timers_tell},
    {"a_timer_that_is_called", a_timer_that_is_called},
    {"where_packets_go", where_packets_go},
    {"what_is_told_of_new_things", what_is_told_of_new_things},
    {"handles_of_what_is_constant", handles_of_what_is_constant},
    {"made_of_parts_of_a_node", made_of_parts_of_a_node},
    {"names_in_full", names_in_full},
    {"clocks_that_follow_a_topic", clocks_that_follow_a_topic},
    {"parameters_of_a_file", parameters_of_a_file},
    {"timers_made_by_their_class", timers_made_by_their_class},
  };
  const int code = run_case(cases, argv[1]);
  rclcpp::shutdown();
  return code;
}
