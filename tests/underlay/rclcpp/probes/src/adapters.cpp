// adapters CASE: types of the program's own in the place of messages; 0 when it holds.

#include "rclcpp/rclcpp.hpp"

#include "case.hpp"
#include "std_msgs/msg/int64.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
using std_msgs::msg::String;

struct Count
{
  int number = 0;
};

template<>
struct rclcpp::TypeAdapter<std::string, String>
{
  using is_specialized = std::true_type;
  using custom_type = std::string;
  using ros_message_type = String;

  static void convert_to_ros_message(const std::string & source, String & destination)
  {
    destination.data = "<" + source + ">";
  }
  static void convert_to_custom(const String & source, std::string & destination)
  {
    destination = source.data + "!";
  }
};

template<>
struct rclcpp::TypeAdapter<Count, std_msgs::msg::Int64>
{
  using is_specialized = std::true_type;
  using custom_type = Count;
  using ros_message_type = std_msgs::msg::Int64;

  static void convert_to_ros_message(const Count & source, std_msgs::msg::Int64 & destination)
  {
    destination.data = source.number;
  }
  static void convert_to_custom(const std_msgs::msg::Int64 & source, Count & destination)
  {
    destination.number = static_cast<int>(source.data);
  }
};

RCLCPP_USING_CUSTOM_TYPE_AS_ROS_MESSAGE_TYPE(Count, std_msgs::msg::Int64);

namespace
{

using Adapted = rclcpp::TypeAdapter<std::string, String>;
static_assert(std::is_same_v<Adapted, rclcpp::adapt_type<std::string>::as<String>>);
static_assert(rclcpp::is_type_adapter<Adapted>::value && !rclcpp::is_type_adapter<String>::value);
static_assert(!rclcpp::TypeAdapter<String>::is_specialized::value);

template<typename Condition>
void spin_until(const rclcpp::Node::SharedPtr & node, Condition holds)
{
  const auto limit = std::chrono::steady_clock::now() + 60s;
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  while (!holds()) {
    EXPECT(std::chrono::steady_clock::now() < limit);
    executor.spin_once(10ms);
  }
}

/// Both ends have either type, and each hears each of the others.
void both_ways(bool intra_process)
{
  auto node = std::make_shared<rclcpp::Node>(
    "node", rclcpp::NodeOptions().use_intra_process_comms(intra_process));
  std::vector<std::string> custom, owned, plain, messages;
  auto first = node->create_subscription<Adapted>(
    "topic", 10, [&](const std::string & text) {custom.push_back(text);});
  auto second = node->create_subscription<Adapted>(
    "topic", 10, [&](std::unique_ptr<std::string> text, const rclcpp::MessageInfo &) {
      owned.push_back(*text);
    });
  auto third = node->create_subscription<Adapted>(
    "topic", 10, [&](String::ConstSharedPtr message) {plain.push_back(message->data);});
  auto fourth = node->create_subscription<String>(
    "topic", 10, [&](const String & message) {messages.push_back(message.data);});
  auto adapted = node->create_publisher<Adapted>("topic", 10);
  auto other = node->create_publisher<String>("topic", 10);
  spin_until(
    node, [&]() {return adapted->get_subscription_count() == 4 && other->get_subscription_count() == 4;});
  adapted->publish(std::string("a"));
  adapted->publish(std::make_unique<std::string>("b"));
  String message;
  message.data = "c";
  adapted->publish(message);
  adapted->publish(std::make_unique<String>(message));
  other->publish(message);
  spin_until(
    node, [&]() {
      return custom.size() == 5 && owned.size() == 5 && plain.size() == 5 && messages.size() == 5;
    });
  const std::multiset<std::string> told{"<a>", "<b>", "c", "c", "c"}, heard{"<a>!", "<b>!", "c!", "c!", "c!"};
  EXPECT(std::multiset<std::string>(custom.begin(), custom.end()) == heard);
  EXPECT(std::multiset<std::string>(owned.begin(), owned.end()) == heard);
  EXPECT(std::multiset<std::string>(plain.begin(), plain.end()) == told);
  EXPECT(std::multiset<std::string>(messages.begin(), messages.end()) == told);
}

void a_type_that_stands_alone()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  int heard = 0;
  auto publisher = node->create_publisher<Count>("topic", rclcpp::QoS(1).transient_local());
  publisher->publish(Count{42});
  auto subscription = node->create_subscription<Count>(
    "topic", rclcpp::QoS(1).transient_local(), [&](const Count & count) {heard = count.number;});
  spin_until(node, [&]() {return heard == 42;});
}

void without_an_executor()
{
  auto node = std::make_shared<rclcpp::Node>("node");
  auto publisher = node->create_publisher<Adapted>("topic", rclcpp::QoS(2).transient_local());
  auto subscription = node->create_subscription<Adapted>(
    "topic", rclcpp::QoS(2).transient_local(), [](const std::string &) {});
  publisher->publish(std::string("a"));
  publisher->publish(std::string("b"));
  std::string text;
  String message;
  rclcpp::MessageInfo info;
  const auto limit = std::chrono::steady_clock::now() + 60s;
  while (!subscription->take(text, info)) {
    EXPECT(std::chrono::steady_clock::now() < limit);
  }
  while (!subscription->take(message, info)) {
    EXPECT(std::chrono::steady_clock::now() < limit);
  }
  EXPECT(text == "<a>!" && message.data == "<b>");
}

}  // namespace

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const Cases cases{
    {"both_ways_by_the_middleware", []() {both_ways(false);}},
    {"both_ways_within_the_process", []() {both_ways(true);}},
    {"a_type_that_stands_alone", a_type_that_stands_alone},
    {"without_an_executor", without_an_executor},
  };
  const int code = run_case(cases, argv[1]);
  rclcpp::shutdown();
  return code;
}
