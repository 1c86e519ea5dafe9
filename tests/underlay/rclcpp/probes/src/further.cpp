// further CASE: what libraries and longer courses use beside the usual; 0 when it holds.

// Nothing of the standard library is included: sources rely on what comes along with rclcpp.
#include "rclcpp/rclcpp.hpp"

#include "case.hpp"
#include "rclcpp/experimental/executors/events_executor/events_executor.hpp"
#include "rcpputils/asserts.hpp"
#include "statistics_msgs/msg/metrics_message.hpp"
#include "statistics_msgs/msg/statistic_data_type.hpp"
#include "std_msgs/msg/float32.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"

using namespace std::chrono_literals;
using rclcpp::Parameter;
using statistics_msgs::msg::MetricsMessage;
using std_msgs::msg::Float32;
using std_msgs::msg::String;
using std_srvs::srv::Trigger;
namespace exceptions = rclcpp::exceptions;

const auto kept = rclcpp::QoS(10).transient_local();

/// Spins until it holds; fails after a minute.
template<typename Condition>
void spin_until(const rclcpp::Node::SharedPtr & node, Condition holds)
{
  const auto limit = std::chrono::steady_clock::now() + 60s;
  rclcpp::executors::SingleThreadedExecutor executor;
  while (!holds()) {
    EXPECT(std::chrono::steady_clock::now() < limit);
    executor.spin_node_once(node, 10ms);
  }
}

void what_comes_along()
{
  std::unordered_map<std::string, std::set<int>> map;
  std::queue<std::variant<int, double>> queue;
  std::deque<std::array<int, 2>> deque;
  std::unordered_set<int> set;
  std::shared_mutex mutex;
  std::condition_variable condition;
  std::this_thread::sleep_for(1ns);
  assert(map.empty() && queue.empty() && deque.empty() && set.empty());
  const std::array<int, 2> numbers{1, 2};
  EXPECT(std::accumulate(numbers.begin(), numbers.end(), 0) == 3);
  EXPECT(std::abs(std::sin(M_PI)) < std::numeric_limits<float>::epsilon());
  EXPECT(std::strcmp(PRId64, "") != 0);
}

/// What a subscription measured while `count` messages came, 20 ms apart: by metric, its values by type.
std::map<std::string, std::map<int, double>> measured(
  const rclcpp::NodeOptions & node_options, bool enabled, int count)
{
  const auto node = std::make_shared<rclcpp::Node>("node", node_options);
  rclcpp::SubscriptionOptions options;
  if (enabled) {
    options.topic_stats_options.state = rclcpp::TopicStatisticsState::Enable;
    options.topic_stats_options.publish_topic = "measured";
    options.topic_stats_options.publish_period = 500ms;
  }
  int came = 0;
  const auto subscription = node->create_subscription<String>(
    "topic", kept, [&](const String &) {++came;}, options);
  std::map<std::string, std::map<int, double>> found;
  const auto statistics = node->create_subscription<MetricsMessage>(
    enabled ? "measured" : "/statistics", 10, [&](const MetricsMessage & message) {
      EXPECT(message.measurement_source_name == "node" && message.unit == "ms");
      EXPECT(rclcpp::Time(message.window_start) < rclcpp::Time(message.window_stop));
      for (const auto & point : message.statistics) {
        found[message.metrics_source][point.data_type] = point.data;
      }
    });
  const auto publisher = node->create_publisher<String>("topic", kept);
  for (int sent = 1; sent <= count; ++sent) {
    publisher->publish(String());
    spin_until(node, [&]() {return came == sent;});
    std::this_thread::sleep_for(20ms);
  }
  spin_until(node, [&]() {return found.size() == 2;});
  return found;
}

void statistics_of_a_topic()
{
  using Type = statistics_msgs::msg::StatisticDataType;
  auto found = measured(rclcpp::NodeOptions(), true, 4);
  auto & age = found.at("message_age");
  auto & period = found.at("message_period");
  EXPECT(age[Type::STATISTICS_DATA_TYPE_SAMPLE_COUNT] == 4);
  EXPECT(period[Type::STATISTICS_DATA_TYPE_SAMPLE_COUNT] == 3);
  EXPECT(age[Type::STATISTICS_DATA_TYPE_MINIMUM] > 0);
  EXPECT(period[Type::STATISTICS_DATA_TYPE_MINIMUM] >= 20);
  for (auto & [metric, values] : found) {
    EXPECT(values[Type::STATISTICS_DATA_TYPE_MINIMUM] <= values[Type::STATISTICS_DATA_TYPE_AVERAGE]);
    EXPECT(values[Type::STATISTICS_DATA_TYPE_AVERAGE] <= values[Type::STATISTICS_DATA_TYPE_MAXIMUM]);
    EXPECT(values[Type::STATISTICS_DATA_TYPE_STDDEV] >= 0);
  }
}

void statistics_of_all_of_a_node()
{
  using Type = statistics_msgs::msg::StatisticDataType;
  auto found = measured(rclcpp::NodeOptions().enable_topic_statistics(true), false, 0);
  EXPECT(found.at("message_age")[Type::STATISTICS_DATA_TYPE_SAMPLE_COUNT] == 0);
  EXPECT(std::isnan(found.at("message_period")[Type::STATISTICS_DATA_TYPE_AVERAGE]));
}

void statistics_need_a_period()
{
  rclcpp::Node node("node");
  rclcpp::SubscriptionOptions options;
  options.topic_stats_options.state = rclcpp::TopicStatisticsState::Enable;
  options.topic_stats_options.publish_period = 0ms;
  const auto make = [&]() {
      return node.create_subscription<String>("topic", 1, [](const String &) {}, options);
    };
  EXPECT(
    THROWN(std::invalid_argument, make()) ==
    "topic_stats_options.publish_period must be greater than 0, specified value of 0 ms");
}

void parameters_of_a_prefix()
{
  rclcpp::Node node("node");
  node.declare_parameters<double>("pid", {{"p", 1.0}, {"i", 2.0}});
  std::map<std::string, Parameter> found;
  EXPECT(node.get_parameters("pid", found) && found.at("i").as_double() == 2.0);
  Parameter one;
  EXPECT(node.get_parameter("pid.p", one) && one.get_value<Parameter>() == one);
}

void parameters_at_once()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  auto other = std::make_shared<rclcpp::Node>("other");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(other);
  std::thread serving([&]() {executor.spin();});
  other->declare_parameter("count", 1);
  other->declare_parameter("name", "Ann");
  auto client = std::make_shared<rclcpp::SyncParametersClient>(node, "other");
  EXPECT(client->wait_for_service(60s) && client->service_is_ready());
  const auto results = client->set_parameters({Parameter("count", 2), Parameter("name", 3)});
  EXPECT(results.size() == 2 && results[0].successful && !results[1].successful);
  EXPECT(client->get_parameter<int>("count") == 2 && client->get_parameter("none", 7) == 7);
  EXPECT(client->get_parameters({"name"}).at(0).as_string() == "Ann");
  EXPECT(client->has_parameter("name") && !client->has_parameter("none"));
  EXPECT(
    THROWN(std::runtime_error, client->get_parameter<int>("none")) == "Parameter 'none' is not set");
  EXPECT(client->get_parameter_types({"count"}).at(0) == rclcpp::PARAMETER_INTEGER);
  EXPECT(client->describe_parameters({"count"}).at(0).name == "count");
  EXPECT(client->set_parameters_atomically({Parameter("name", "Bob")}).successful);
  EXPECT(
    client->set_parameters_atomically({Parameter("none", 1)}).reason ==
    "One or more parameters were not declared before setting");
  const auto names = client->list_parameters({}, 1).names;
  EXPECT(std::find(names.begin(), names.end(), "name") != names.end());
  rclcpp::SyncParametersClient in_vain(node.get(), "nobody");
  EXPECT(!in_vain.service_is_ready() && in_vain.get_parameters({"x"}, 1ms).empty());
  EXPECT(
    THROWN(std::runtime_error, in_vain.list_parameters({}, 1, 1ms)) ==
    "Unable to get result of list parameters service call.");
  executor.cancel();
  serving.join();
}

void parameters_later()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  node->declare_parameter("count", 1);
  auto client = std::make_shared<rclcpp::AsyncParametersClient>(node);
  int told = 0;
  auto events = client->on_parameter_event(
    [&](const rcl_interfaces::msg::ParameterEvent::SharedPtr event) {
      told += static_cast<int>(event->changed_parameters.size());
    });
  EXPECT(client->wait_for_service(60s));
  spin_until(node, [&]() {return events->get_publisher_count() == 1;});
  bool called = false;
  auto set = client->set_parameters(
    {Parameter("count", 5)}, [&](auto future) {called = future.get().at(0).successful;});
  EXPECT(rclcpp::spin_until_future_complete(node, set) == rclcpp::FutureReturnCode::SUCCESS && called);
  auto get = client->get_parameters({"count"});
  EXPECT(rclcpp::spin_until_future_complete(node, get) == rclcpp::FutureReturnCode::SUCCESS);
  EXPECT(get.get().at(0).as_int() == 5);
  spin_until(node, [&]() {return told > 0;});
}

void bytes()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  const rclcpp::Serialization<String> serialization;
  std::multiset<std::string> heard;
  const auto hear = [&](const rclcpp::SerializedMessage & message) {
      String text;
      serialization.deserialize_message(&message, &text);
      heard.insert(text.data);
    };
  auto generic = node->create_generic_subscription(
    "topic", "std_msgs/msg/String", kept,
    [&](std::shared_ptr<rclcpp::SerializedMessage> message) {hear(*message);});
  auto raw = node->create_subscription<String>(
    "topic", kept, [&](std::shared_ptr<const rclcpp::SerializedMessage> message) {hear(*message);});
  auto typed = node->create_subscription<String>(
    "topic", kept, [&](const auto & text) {heard.insert(text.data);});
  EXPECT(generic->is_serialized() && raw->is_serialized() && !typed->is_serialized());
  String text;
  text.data = "bytes";
  rclcpp::SerializedMessage message;
  serialization.serialize_message(&text, &message);
  const rclcpp::SerializedMessage copy(message);
  EXPECT(copy.size() == message.size() && copy.size() > 5);
  auto publisher = node->create_publisher<String>("topic", kept);
  publisher->publish(copy);
  using Deleter = std::function<void (String *)>;
  auto loan = publisher->borrow_loaned_message();
  static_assert(std::is_same_v<decltype(loan.release()), std::unique_ptr<String, Deleter>>);
  loan.get().data = "loan";
  publisher->publish(std::move(loan));
  EXPECT(!loan.is_valid());
  EXPECT(rclcpp::LoanedMessage<String>(*publisher, std::allocator<String>()).release()->data.empty());
  auto unnamed = node->create_generic_publisher("topic", "std_msgs/msg/String", kept);
  unnamed->publish(copy);
  spin_until(node, [&]() {return heard.size() == 9;});
  EXPECT(heard.count("bytes") == 6 && heard.count("loan") == 3);
  EXPECT(
    THROWN(std::runtime_error, node->create_generic_publisher("x", "String", 1)) ==
    "Message type is not of the form package/type and cannot be processed");
  EXPECT(
    THROWN(std::runtime_error, node->create_generic_publisher("x", "no_such/msg/Type", 1)).find(
      "Something went wrong loading the typesupport library for message type no_such/msg/Type.") == 0);
}

void bytes_in_wrong_hands()
{
  using rcpputils::IllegalStateException;
  const rclcpp::Serialization<String> serialization;
  String text;
  rclcpp::SerializedMessage message, other(2);
  EXPECT(
    THROWN(IllegalStateException, serialization.serialize_message(&text, nullptr)) ==
    "Serialized message is nullpointer.");
  EXPECT(!THROWN(IllegalStateException, serialization.deserialize_message(&message, &text)).empty());
  serialization.serialize_message(&text, &message);
  EXPECT(!THROWN(IllegalStateException, serialization.deserialize_message(&message, nullptr)).empty());
  other = std::move(message);
  EXPECT(other.size() > 0 && message.capacity() == 0);
  rcl_serialized_message_t taken = other.get_rcl_serialized_message();
  other.release_rcl_serialized_message();
  const rclcpp::SerializedMessage owner(std::move(taken));
  EXPECT(taken.allocator.allocate == nullptr && owner.size() > 0);
}

void executors_of_nodes()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  int calls = 0;
  auto timer = node->create_wall_timer(0ms, [&]() {++calls;});
  rclcpp::experimental::executors::EventsExecutor executor;
  executor.spin_node_once(node);
  executor.spin_node_some(node);
  EXPECT(calls == 2);
  executor.spin_node_all(node, 1ms);
  EXPECT(THROWN(std::invalid_argument, executor.spin_all(0ms)) == "max_duration must be positive");
  executor.add_node(node);
  EXPECT(executor.get_automatically_added_callback_groups_from_nodes().size() == 1);
  EXPECT(executor.get_manually_added_callback_groups().empty());
}

/// What a library takes instead of a node.
void parts_of_a_node()
{
  auto node = std::make_shared<rclcpp::Node>("node", "space");
  EXPECT(node->get_node_logging_interface()->get_logger().get_name() == std::string("space.node"));
  EXPECT(node->get_node_clock_interface()->get_clock() == node->get_clock());
  EXPECT(node->get_node_services_interface()->resolve_service_name("~/x") == "/space/node/x");
  auto topics = node->get_node_topics_interface();
  EXPECT(topics->resolve_topic_name("x") == "/space/x");
  auto publisher = rclcpp::create_publisher<String>(topics, "x", kept);
  bool heard = false;
  auto subscription = rclcpp::create_subscription<String>(
    topics, "x", kept, [&](const String &) {heard = true;});
  publisher->publish(String());
  spin_until(node, [&]() {return heard;});
  auto service = rclcpp::create_service<Trigger>(
    node, "go", [](const Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) {});
  auto client = rclcpp::create_client<Trigger>(node, "go");
  EXPECT(client->get_service_name() == std::string(service->get_service_name()));
  const rcl_node_t * handle = node->get_node_base_interface()->get_rcl_node_handle();
  EXPECT(rclcpp::get_node_logger(handle).get_name() == std::string("space.node"));
}

void content_filters()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  std::vector<float> heard;
  rclcpp::SubscriptionOptions options;
  options.content_filter_options.filter_expression = "data > %0";
  options.content_filter_options.expression_parameters = {"3.0"};
  auto subscription = node->create_subscription<Float32>(
    "topic", kept, [&](const Float32 & number) {heard.push_back(number.data);}, options);
  EXPECT(subscription->is_cft_enabled());
  EXPECT(subscription->get_content_filter().filter_expression == "data > %0");
  auto publisher = node->create_publisher<Float32>("topic", kept);
  for (const float data : {1.0f, 5.0f}) {
    publisher->publish(Float32().set__data(data));
  }
  spin_until(node, [&]() {return !heard.empty();});
  EXPECT(heard == std::vector<float>{5.0f});
  subscription->set_content_filter("data < %0", {"2.0"});
  EXPECT(subscription->get_content_filter().expression_parameters.at(0) == "2.0");
}

void introspection()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  auto service = node->create_service<Trigger>(
    "go", [](const Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) {});
  auto client = node->create_client<Trigger>("go");
  service->configure_introspection(
    node->get_clock(), rclcpp::SystemDefaultsQoS(), RCL_SERVICE_INTROSPECTION_CONTENTS);
  client->configure_introspection(
    node->get_clock(), rclcpp::SystemDefaultsQoS(), RCL_SERVICE_INTROSPECTION_METADATA);
  spin_until(node, [&]() {return node->count_publishers("go/_service_event") == 2;});
}

/// Names that go wrong where the one or the other function looks at them.
void wrong_names()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  EXPECT(
    THROWN(exceptions::InvalidTopicNameError, node->create_publisher<String>("a//b", 1)).find(
      "must not contain repeated '/'") != std::string::npos);
  EXPECT(!THROWN(exceptions::InvalidTopicNameError, node->count_publishers("no topic")).empty());
  EXPECT(
    THROWN(exceptions::NameValidationError, node->create_sub_node("")).find("empty sub-namespace") !=
    std::string::npos);
  EXPECT(!THROWN(exceptions::InvalidNamespaceError, node->create_sub_node("~x")).empty());
}

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  if (argv[1] == std::string("levels")) {
    auto node = std::make_shared<rclcpp::Node>("levels", rclcpp::NodeOptions().enable_logger_service(true));
    auto timer = node->create_wall_timer(10ms, [&]() {RCLCPP_DEBUG(node->get_logger(), "now heard");});
    RCLCPP_INFO(node->get_logger(), "ready");
    rclcpp::spin(node);
    return 0;
  }
  const Cases cases{
    {"what_comes_along", what_comes_along},
    {"statistics_of_a_topic", statistics_of_a_topic},
    {"statistics_of_all_of_a_node", statistics_of_all_of_a_node},
    {"statistics_need_a_period", statistics_need_a_period},
    {"parameters_of_a_prefix", parameters_of_a_prefix},
    {"parameters_at_once", parameters_at_once},
    {"parameters_later", parameters_later},
    {"bytes", bytes},
    {"bytes_in_wrong_hands", bytes_in_wrong_hands},
    {"executors_of_nodes", executors_of_nodes},
    {"parts_of_a_node", parts_of_a_node},
    {"content_filters", content_filters},
    {"introspection", introspection},
    {"wrong_names", wrong_names},
  };
  const int code = run_case(cases, argv[1]);
  rclcpp::shutdown();
  return code;
}
