// units CASE: what needs no other node; 0 when it holds.

#include <chrono>
#include <cstdlib>
#include <functional>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "case.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"

using namespace std::chrono_literals;
using rclcpp::Duration;
using rclcpp::Parameter;
using rclcpp::ParameterValue;
using rclcpp::Time;
using std_msgs::msg::String;
namespace exceptions = rclcpp::exceptions;

void durations()
{
  EXPECT(Duration(1, 500000000u).seconds() == 1.5);
  EXPECT(Duration(2s) + Duration(300ms) == Duration::from_nanoseconds(2300000000));
  EXPECT(Duration(1s) - Duration(3s) == Duration(-2s));
  EXPECT(Duration(2s) * 0.25 == Duration(500ms));
  EXPECT(Duration::from_seconds(-0.5).nanoseconds() == -500000000);
  EXPECT(Duration(1500ms).to_chrono<std::chrono::milliseconds>() == 1500ms);
  EXPECT(Duration(1s) < Duration(2s) && Duration(2s) >= Duration(2s) && Duration(1s) != Duration(2s));
  const builtin_interfaces::msg::Duration message = Duration(-1500ms);
  EXPECT(message.sec == -2 && message.nanosec == 500000000u);
  EXPECT(Duration(message) == Duration(-1500ms));
  const auto longest = Duration::from_nanoseconds(std::numeric_limits<std::int64_t>::max());
  EXPECT(!THROWN(std::overflow_error, longest + Duration(1s)).empty());
  EXPECT(!THROWN(std::overflow_error, longest * 2.0).empty());
  EXPECT(!THROWN(std::underflow_error, longest * -2.0).empty());
  EXPECT(!THROWN(std::underflow_error, Duration(-1ns) - longest).empty());
  EXPECT(!THROWN(std::runtime_error, Duration(-1s).to_rmw_time()).empty());
  EXPECT(Duration::from_rmw_time(Duration(1500ms).to_rmw_time()) == Duration(1500ms));
  constexpr auto most = std::numeric_limits<std::uint64_t>::max();
  EXPECT(Duration::from_rmw_time({0, most}) == longest && Duration::from_rmw_time({most, 0}) == longest);
  EXPECT(Duration::from_rmw_time({9223372036, 0}).nanoseconds() == 9223372036000000000);
}

void times()
{
  const Time time(10, 250000000u);
  EXPECT(time.seconds() == 10.25 && time.get_clock_type() == RCL_SYSTEM_TIME);
  EXPECT(time + Duration(1s) - time == Duration(1s));
  EXPECT(time - Duration(1s) < time && time + 1s > time);
  const builtin_interfaces::msg::Time message = time;
  EXPECT(message.sec == 10 && message.nanosec == 250000000u);
  EXPECT(Time(message).get_clock_type() == RCL_ROS_TIME);
  EXPECT(
    THROWN(std::runtime_error, time == Time(message)) ==
    "can't compare times with different time sources");
  EXPECT(
    THROWN(std::runtime_error, time - Time(message)) ==
    "can't subtract times with different time sources");
  EXPECT(!THROWN(std::runtime_error, Time(-1, 0)).empty());
  EXPECT(!THROWN(std::overflow_error, Time(std::numeric_limits<std::int64_t>::max()) + 1s).empty());
}

void clocks_and_rates()
{
  rclcpp::Clock steady(RCL_STEADY_TIME);
  const Time begin = steady.now();
  EXPECT(steady.sleep_for(Duration(2ms)));
  EXPECT(steady.now() - begin >= Duration(2ms));
  EXPECT(steady.sleep_until(begin));
  rclcpp::WallRate rate(1000.0);
  EXPECT(rate.period() == 1ms);
  const Time first = steady.now();
  for (int i = 0; i < 5; ++i) {
    rate.sleep();
  }
  EXPECT(steady.now() - first >= Duration(3ms));
  rclcpp::Rate(Duration(1ms)).sleep();
  EXPECT(!THROWN(std::invalid_argument, rclcpp::Rate(0.0)).empty());
  EXPECT(!THROWN(std::invalid_argument, rclcpp::WallRate(Duration(-1s))).empty());
  rclcpp::WallRate slow(Duration(1h));
  rclcpp::shutdown();
  EXPECT(slow.sleep());  // as in a loop that Ctrl+C ends
  const std::string invalid = "context cannot be slept with because it's invalid";
  EXPECT(THROWN(std::runtime_error, steady.sleep_for(Duration(1h))) == invalid);
  EXPECT(THROWN(std::runtime_error, steady.sleep_until(begin)) == invalid);
}

void simulated_time_jumps()
{
  rclcpp::Clock clock(RCL_ROS_TIME);
  int before = 0, after = 0;
  rcl_jump_threshold_t any{};
  any.on_clock_change = true;
  auto handler =
    clock.create_jump_callback([&]() {++before;}, [&](const rcl_time_jump_t &) {++after;}, any);
  EXPECT(rcl_enable_ros_time_override(clock.get_clock_handle()) == RCL_RET_OK);
  EXPECT(before == 1 && after == 1);
  EXPECT(clock.ros_time_is_active() && !clock.started());
  handler.reset();
  EXPECT(rcl_disable_ros_time_override(clock.get_clock_handle()) == RCL_RET_OK);
  EXPECT(before == 1 && clock.started());
}

void qos_profiles()
{
  const rclcpp::QoS plain(10);
  EXPECT(plain.depth() == 10 && plain.history() == rclcpp::HistoryPolicy::KeepLast);
  EXPECT(plain.reliability() == rclcpp::ReliabilityPolicy::Reliable);
  EXPECT(plain.durability() == rclcpp::DurabilityPolicy::Volatile);
  const auto latched = rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable();
  EXPECT(latched.durability() == rclcpp::DurabilityPolicy::TransientLocal);
  EXPECT(rclcpp::SensorDataQoS().reliability() == rclcpp::ReliabilityPolicy::BestEffort);
  EXPECT(rclcpp::SensorDataQoS().depth() == 5);
  EXPECT(rclcpp::QoS(rclcpp::KeepAll()).history() == rclcpp::HistoryPolicy::KeepAll);
  EXPECT(rclcpp::QoS(1).deadline(100ms).deadline() == Duration(100ms));
  EXPECT(rclcpp::QoS(3) == rclcpp::QoS(3) && rclcpp::QoS(3) != rclcpp::QoS(4));
  const auto checked = rclcpp::qos_check_compatible(rclcpp::QoS(1).best_effort(), rclcpp::QoS(1));
  EXPECT(checked.compatibility == rclcpp::QoSCompatibility::Error && !checked.reason.empty());
}

void parameter_values()
{
  EXPECT(Parameter("p", 3).as_int() == 3 && Parameter("p", 3.5).as_double() == 3.5);
  EXPECT(Parameter("p", "text").as_string() == "text" && Parameter("p", true).as_bool());
  EXPECT(Parameter("p", std::vector<int>{1, 2}).as_integer_array() == std::vector<std::int64_t>{1, 2});
  EXPECT(Parameter("p", std::vector<float>{0.5f}).get_value<std::vector<double>>().at(0) == 0.5);
  EXPECT(ParameterValue(7).get<int>() == 7 && ParameterValue(1.5).get<float>() == 1.5f);
  EXPECT(ParameterValue(std::vector<std::string>{"a"}).get<rclcpp::PARAMETER_STRING_ARRAY>().size() == 1);
  EXPECT(
    THROWN(rclcpp::ParameterTypeException, ParameterValue(7).get<std::string>()) ==
    "expected [string] got [integer]");
  EXPECT(
    THROWN(exceptions::InvalidParameterTypeException, Parameter("p", 7).get_value<bool>()) ==
    "parameter 'p' has invalid type: expected [bool] got [integer]");
  EXPECT(
    THROWN(rclcpp::ParameterTypeException, Parameter("p", 7).as_bool()) ==
    "expected [bool] got [integer]");
  EXPECT(to_string(ParameterValue(std::vector<bool>{true, false})) == "[true, false]");
  EXPECT(to_string(ParameterValue(0.1)) == "0.100000");
  EXPECT(to_string(ParameterValue(std::vector<double>{0.1, 1e300})) == "[0.1, 1e+300]");
  EXPECT(to_string(ParameterValue(std::vector<std::string>{"R", "2"})) == "[R, 2]");
  EXPECT(
    rclcpp::to_string(std::vector<Parameter>{Parameter("p", 7), Parameter("q", true)}) ==
    "{\"p\": {\"type\": \"integer\", \"value\": \"7\"}, \"q\": {\"type\": \"bool\", \"value\": \"true\"}}");
  std::ostringstream text;
  text << Parameter("p", 7);
  EXPECT(text.str() == "{\"name\": \"p\", \"type\": \"integer\", \"value\": \"7\"}");
  EXPECT(Parameter::from_parameter_msg(Parameter("p", 2.0).to_parameter_msg()) == Parameter("p", 2.0));
  rcl_interfaces::msg::ParameterEvent event;
  event.node = "/node";
  const auto part = [&](const char * node) {
      return rclcpp::ParameterEventHandler::get_parameter_from_event(event, "p", node);
    };
  EXPECT(part("/node") == Parameter("p", rclcpp::PARAMETER_NOT_SET));
  EXPECT(
    THROWN(std::runtime_error, part("/other")) ==
    "The node name '/other' of parameter 'p' doesn't match the node name '/node' in parameter event");
}

void parameters_of_a_node()
{
  rclcpp::NodeOptions options;
  options.parameter_overrides({{"given", 5}, {"a.b", 1}, {"a.c.d", 2}});
  rclcpp::Node node("node", options);
  EXPECT(node.declare_parameter("given", 1) == 5);
  EXPECT(node.declare_parameter("text", "default") == "default");
  EXPECT(node.declare_parameter<int>("a.b") == 1 && node.declare_parameter<int>("a.c.d", 7) == 2);
  EXPECT(
    THROWN(exceptions::ParameterUninitializedException, node.declare_parameter<bool>("unset")) ==
    "parameter 'unset' is not initialized");
  EXPECT(!THROWN(exceptions::ParameterAlreadyDeclaredException, node.declare_parameter("text", 1)).empty());
  EXPECT(!THROWN(exceptions::ParameterNotDeclaredException, node.get_parameter("other")).empty());
  EXPECT(
    THROWN(exceptions::ParameterNotDeclaredException, node.set_parameter({"other", 1})) ==
    "parameter 'other' cannot be set because it was not declared");
  EXPECT(node.get_parameter_or("other", 8) == 8);
  int given = 0;
  EXPECT(node.get_parameter("given", given) && given == 5);
  EXPECT(!node.get_parameter("other", given) && given == 5);
  const auto refused = node.set_parameter({"given", "text"});
  EXPECT(
    refused.reason ==
    "Wrong parameter type, parameter {given} is of type {integer}, setting it to {string} is not allowed.");
  EXPECT(node.list_parameters({"a"}, 1).names == std::vector<std::string>{"a.b"});
  EXPECT(node.list_parameters({"a"}, 0).names.size() == 2);
  std::map<std::string, int> below;
  EXPECT(node.get_parameters("a", below) && below == (std::map<std::string, int>{{"b", 1}, {"c.d", 2}}));
  options.automatically_declare_parameters_from_overrides(true);
  options.append_parameter_override("use_sim_time", "no");
  EXPECT(
    THROWN(std::invalid_argument, rclcpp::Node("other", options)) ==
    "Invalid type for parameter 'use_sim_time', should be 'bool'");
}

void parameters_without_a_value()
{
  rclcpp::Node node("node");
  rcl_interfaces::msg::ParameterDescriptor any;
  any.dynamic_typing = true;
  node.declare_parameter("any", ParameterValue(), any);
  node.declare_parameter("count", 1);
  EXPECT(node.set_parameter(Parameter("any")).successful && node.has_parameter("any"));
  EXPECT(node.set_parameter({"any", 1}).successful && node.get_parameter("any").as_int() == 1);
  EXPECT(node.set_parameter(Parameter("any")).successful && !node.has_parameter("any"));
  EXPECT(
    node.set_parameter(Parameter("count")).reason == "cannot undeclare a statically typed parameter");
}

void described_parameters()
{
  rclcpp::Node node("node");
  rcl_interfaces::msg::ParameterDescriptor fixed, even;
  fixed.read_only = true;
  even.integer_range.resize(1);
  even.integer_range[0].from_value = 0;
  even.integer_range[0].to_value = 10;
  even.integer_range[0].step = 2;
  node.declare_parameter("fixed", true, fixed);
  node.declare_parameter("even", 4, even);
  EXPECT(
    node.set_parameter({"fixed", false}).reason ==
    "parameter 'fixed' cannot be set because it is read-only");
  for (const int odd : {5, -2, 12}) {
    EXPECT(
      node.set_parameter({"even", odd}).reason ==
      "Parameter {even} doesn't comply with integer range.");
  }
  EXPECT(node.set_parameter({"even", 10}).successful && node.get_parameter("even").as_int() == 10);
  EXPECT(!THROWN(exceptions::InvalidParameterValueException, node.declare_parameter("odd", 5, even)).empty());
}

void qos_overrides()
{
  rclcpp::NodeOptions options;
  options.append_parameter_override("qos_overrides./topic.publisher.depth", 7);
  options.append_parameter_override("qos_overrides./topic.publisher.reliability", "best_effort");
  rclcpp::Node node("node", options);
  rclcpp::PublisherOptions open;
  open.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
  const auto qos = node.create_publisher<String>("topic", 10, open)->get_actual_qos();
  EXPECT(qos.depth() == 7 && qos.reliability() == rclcpp::ReliabilityPolicy::BestEffort);
  EXPECT(node.get_parameter("qos_overrides./topic.publisher.history").as_string() == "keep_last");
  EXPECT(node.create_publisher<String>("other", 10)->get_actual_qos().depth() == 10);
  open.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies(
    [](const rclcpp::QoS &) {return rclcpp::QosCallbackResult().set__reason("no");});
  EXPECT(
    !THROWN(
      exceptions::InvalidQosOverridesException,
      node.create_publisher<String>("third", 10, open)).empty());
}

void next_message()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  const auto kept = rclcpp::QoS(1).transient_local();
  auto publisher = node->create_publisher<String>("topic", kept);
  String message, heard;
  EXPECT(!rclcpp::wait_for_message(heard, node, "topic", 5ms, kept));
  message.data = "kept";
  publisher->publish(message);
  EXPECT(rclcpp::wait_for_message(heard, node, "topic", 10s, kept) && heard.data == "kept");
}

void parameter_callbacks()
{
  rclcpp::Node node("node");
  node.declare_parameter("x", 1);
  node.declare_parameter("y", 1);
  auto widen = node.add_pre_set_parameters_callback(
    [](std::vector<Parameter> & given) {given.emplace_back("y", given.front().as_int() + 1);});
  std::string inside;
  auto judge = node.add_on_set_parameters_callback(
    [&](const std::vector<Parameter> & given) {
      inside = THROWN(exceptions::ParameterModifiedInCallbackException, node.set_parameter({"x", 9}));
      rcl_interfaces::msg::SetParametersResult result;
      result.successful = given.front().as_int() < 5;
      result.reason = "below five";
      return result;
    });
  EXPECT(node.set_parameter({"x", 3}).successful);
  EXPECT(node.get_parameter("x").as_int() == 3 && node.get_parameter("y").as_int() == 4);
  EXPECT(!inside.empty());
  EXPECT(node.set_parameter({"x", 6}).reason == "below five");
  EXPECT(node.get_parameter("x").as_int() == 3);
  node.remove_on_set_parameters_callback(judge.get());
  widen.reset();
  EXPECT(node.set_parameter({"x", 6}).successful && node.get_parameter("y").as_int() == 4);
}

void names()
{
  EXPECT(
    THROWN(exceptions::InvalidNodeNameError, rclcpp::Node("a-b")) ==
    "Invalid node name: node name must not contain characters other than alphanumerics or '_':\n"
    "  'a-b'\n    ^\n");
  EXPECT(!THROWN(exceptions::InvalidNamespaceError, rclcpp::Node("a", "b c")).empty());
  rclcpp::Node node("node", "space");
  EXPECT(!THROWN(exceptions::InvalidTopicNameError, node.create_publisher<String>("a b", 1)).empty());
  EXPECT(
    !THROWN(
      exceptions::InvalidServiceNameError,
      node.create_client<std_srvs::srv::Trigger>("a b")).empty());
  EXPECT(node.get_namespace() == std::string("/space"));
  EXPECT(node.get_fully_qualified_name() == std::string("/space/node"));
  EXPECT(node.get_logger().get_name() == std::string("space.node"));
  EXPECT(node.create_publisher<String>("t", 1)->get_topic_name() == std::string("/space/t"));
  EXPECT(node.create_publisher<String>("~/t", 1)->get_topic_name() == std::string("/space/node/t"));
  auto sub = std::make_shared<rclcpp::Node>("other")->create_sub_node("below");
  EXPECT(sub->create_publisher<String>("t", 1)->get_topic_name() == std::string("/below/t"));
}

void contexts()
{
  EXPECT(rclcpp::ok());
  EXPECT(!THROWN(rclcpp::ContextAlreadyInitialized, rclcpp::init(0, nullptr)).empty());
  auto context = std::make_shared<rclcpp::Context>();
  rclcpp::NodeOptions options;
  options.context(context);
  EXPECT(
    THROWN(exceptions::RCLInvalidArgument, rclcpp::Node("node", options)).find(
      "failed to create guard condition: context argument is null") == 0);
  const char * unknown[] = {"program", "--ros-args", "--no-such-thing"};
  EXPECT(
    THROWN(exceptions::UnknownROSArgsError, context->init(3, unknown)) ==
    "found unknown ROS arguments: '--no-such-thing'");
  const char * wrong[] = {"program", "--ros-args", "-p", "no value"};
  EXPECT(!THROWN(exceptions::RCLInvalidROSArgsError, context->init(4, wrong)).empty());
  rclcpp::InitOptions own_domain;
  own_domain.set_domain_id(7);
  context->init(0, nullptr, own_domain);
  EXPECT(context->get_domain_id() == 7);
  setenv("ROS_DOMAIN_ID", "42", true);
  own_domain.use_default_domain_id();
  EXPECT(own_domain.get_domain_id() == 42);
  bool called = false;
  context->add_on_shutdown_callback([&]() {called = true;});
  EXPECT(rclcpp::shutdown(context, "because") && called && context->shutdown_reason() == "because");
  EXPECT(!rclcpp::ok(context) && rclcpp::ok());
  const char * words[] = {"program", "mine", "--ros-args", "-r", "a:=b", "--", "yours"};
  EXPECT(
    rclcpp::remove_ros_arguments(7, words) == std::vector<std::string>{"program", "mine", "yours"});
}

void callbacks_of_a_shutdown()
{
  auto context = std::make_shared<rclcpp::Context>();
  context->init(0, nullptr);
  std::string reason;
  context->add_on_shutdown_callback([]() {throw std::runtime_error("the first one");});
  context->add_on_shutdown_callback(
    [&]() {
      // Somebody else may ask while the callback waits for it.
      std::thread([&]() {reason = context->get_rcl_context() ? context->shutdown_reason() : "";}).join();
    });
  EXPECT(THROWN(std::runtime_error, context->shutdown("because")) == "the first one");
  EXPECT(reason == "because" && !context->is_valid());
  context->init(0, nullptr);
  EXPECT(context->is_valid() && context->shutdown_reason().empty());
}

void rosout_of_namesakes()
{
  auto first = std::make_shared<rclcpp::Node>("same");
  auto second = std::make_shared<rclcpp::Node>("same");
  EXPECT(first->count_publishers("/rosout") == 1);
  second.reset();
  EXPECT(first->count_publishers("/rosout") == 1);
  second = std::make_shared<rclcpp::Node>("same");
  first.reset();
  EXPECT(second->count_publishers("/rosout") == 1);
  auto other = std::make_shared<rclcpp::Node>("other");
  EXPECT(other->count_publishers("/rosout") == 2);
  second.reset();
  EXPECT(other->count_publishers("/rosout") == 1);
}

void waiting_for_a_service()
{
  using Trigger = std_srvs::srv::Trigger;
  auto node = std::make_shared<rclcpp::Node>("node");
  auto client = node->create_client<Trigger>("go");
  EXPECT(!client->wait_for_service(0s) && !client->wait_for_service(5ms) && !client->service_is_ready());
  rclcpp::Service<Trigger>::SharedPtr service;
  std::thread later(
    [&]() {
      service = node->create_service<Trigger>(
        "go", [](const Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) {});
    });
  const bool found = client->wait_for_service(-1s);
  later.join();
  EXPECT(found);
  rclcpp::shutdown();
  EXPECT(!client->wait_for_service() && !client->wait_for_service(0s));
}

void graph()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  auto publisher = node->create_publisher<String>("topic", rclcpp::QoS(3).best_effort());
  auto service = node->create_service<std_srvs::srv::Trigger>(
    "go", [](const std::shared_ptr<std_srvs::srv::Trigger::Request>,
    std::shared_ptr<std_srvs::srv::Trigger::Response>) {});
  auto client = node->create_client<std_srvs::srv::Trigger>("go");
  EXPECT(client->wait_for_service());
  EXPECT(node->count_publishers("topic") == 1 && node->count_subscribers("/topic") == 0);
  EXPECT(node->count_services("go") == 1 && node->count_clients("go") == 1);
  EXPECT(node->get_topic_names_and_types().at("/topic").at(0) == "std_msgs/msg/String");
  EXPECT(node->get_service_names_and_types().count("/go") == 1);
  EXPECT(node->get_service_names_and_types_by_node("node", "/").count("/go") == 1);
  const auto seen = node->get_publishers_info_by_topic("topic");
  EXPECT(seen.size() == 1 && seen[0].node_name() == "node");
  EXPECT(seen[0].qos_profile().reliability() == rclcpp::ReliabilityPolicy::BestEffort);
  const auto names = node->get_node_names();
  EXPECT(std::find(names.begin(), names.end(), "/node") != names.end());
}

/// What tutorials write in more than one way.
void usual_forms()
{
  auto node = rclcpp::Node::make_shared(
    "node", rclcpp::NodeOptions().automatically_declare_parameters_from_overrides(true));
  int calls = 0;
  const auto count = [&]() {++calls;};
  const std::vector<rclcpp::TimerBase::SharedPtr> timers{
    node->create_wall_timer(std::chrono::duration<double>(1.0 / 2000.0), count),
    node->create_timer(std::chrono::milliseconds(0), count),
    rclcpp::create_timer(node, node->get_clock(), Duration(0ms), count),
    rclcpp::create_timer(node.get(), node->get_clock(), 0ms, std::bind(count))};
  rclcpp::Rate(500).sleep();
  rclcpp::Rate(1ms).sleep();
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin_some();
  EXPECT(calls == 4);
  auto publisher =
    rclcpp::create_publisher<String>(*node, "topic", rclcpp::QoS(rclcpp::KeepLast(5)).best_effort());
  auto subscription = rclcpp::create_subscription<String>(
    node, "topic", rclcpp::SensorDataQoS(), [](const String::SharedPtr) {});
  rclcpp::Publisher<String>::SharedPtr same = publisher;
  EXPECT(subscription->get_topic_name() == std::string("/topic") && same->get_actual_qos().depth() == 5);
  EXPECT(node->declare_parameter<std::vector<double>>("numbers", {1.0, 2.0}).size() == 2);
  EXPECT(node->declare_parameter<int>("count", 3) == 3 && node->declare_parameter<double>("x", 1) == 1.0);
  node->declare_parameter("typed", rclcpp::PARAMETER_DOUBLE);
  builtin_interfaces::msg::Time stamp = node->now();
  const Duration passed = node->now() - stamp;
  EXPECT(passed >= Duration(0, 0) && (node->get_clock()->now() - Time(stamp)).seconds() >= 0.0);
}

void loggers()
{
  auto log = rclcpp::get_logger("log");
  EXPECT(log.get_effective_level() == rclcpp::Logger::Level::Info);
  log.set_level(rclcpp::Logger::Level::Error);
  EXPECT(log.get_effective_level() == rclcpp::Logger::Level::Error);
  EXPECT(log.get_child("child").get_name() == std::string("log.child"));
  EXPECT(log.get_child("child").get_effective_level() == rclcpp::Logger::Level::Error);
}

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const Cases cases{
    {"durations", durations},
    {"times", times},
    {"clocks_and_rates", clocks_and_rates},
    {"simulated_time_jumps", simulated_time_jumps},
    {"qos_profiles", qos_profiles},
    {"parameter_values", parameter_values},
    {"parameters_of_a_node", parameters_of_a_node},
    {"parameters_without_a_value", parameters_without_a_value},
    {"described_parameters", described_parameters},
    {"parameter_callbacks", parameter_callbacks},
    {"qos_overrides", qos_overrides},
    {"next_message", next_message},
    {"names", names},
    {"contexts", contexts},
    {"callbacks_of_a_shutdown", callbacks_of_a_shutdown},
    {"rosout_of_namesakes", rosout_of_namesakes},
    {"waiting_for_a_service", waiting_for_a_service},
    {"graph", graph},
    {"usual_forms", usual_forms},
    {"loggers", loggers},
  };
  const int code = run_case(cases, argv[1]);
  rclcpp::shutdown();
  return code;
}
