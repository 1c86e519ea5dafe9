// local CASE: messages that are handed over within the process; 0 when it holds.

#include "rclcpp/rclcpp.hpp"

#include "case.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
using rclcpp::IntraProcessSetting;
using std_msgs::msg::String;

namespace
{

struct Room
{
  rclcpp::Node::SharedPtr node =
    std::make_shared<rclcpp::Node>("node", rclcpp::NodeOptions().use_intra_process_comms(true));
  rclcpp::executors::SingleThreadedExecutor executor;

  Room() {executor.add_node(node);}

  template<typename Condition>
  void spin_until(Condition holds)
  {
    const auto limit = std::chrono::steady_clock::now() + 60s;
    while (!holds()) {
      EXPECT(std::chrono::steady_clock::now() < limit);
      executor.spin_once(10ms);
    }
  }

  /// Long enough for what must not come.
  void spin_a_while()
  {
    const auto end = std::chrono::steady_clock::now() + 300ms;
    while (std::chrono::steady_clock::now() < end) {
      executor.spin_once(10ms);
    }
  }
};

std::unique_ptr<String> message(const std::string & text)
{
  auto made = std::make_unique<String>();
  made->data = text;
  return made;
}

void the_message_itself()
{
  Room room;
  const void * heard = nullptr;
  bool is_local = false;
  auto publisher = room.node->create_publisher<String>("topic", 10);
  EXPECT(publisher->get_intra_process_subscription_count() == 0);
  auto subscription = room.node->create_subscription<String>(
    "topic", 10, [&](std::unique_ptr<String> given, const rclcpp::MessageInfo & info) {
      heard = given.get();
      is_local = info.get_rmw_message_info().from_intra_process;
    });
  EXPECT(publisher->get_intra_process_subscription_count() == 1);
  EXPECT(!publisher->can_loan_messages());
  auto sent = message("a");
  const void * const address = sent.get();
  publisher->publish(std::move(sent));
  room.spin_until([&]() {return heard;});
  EXPECT(heard == address && is_local);
  heard = nullptr;
  String copied;
  publisher->publish(copied);
  room.spin_until([&]() {return heard;});
  EXPECT(heard != &copied);
  subscription.reset();
  EXPECT(publisher->get_intra_process_subscription_count() == 0);
}

void who_shares_and_who_owns()
{
  Room room;
  std::vector<const void *> shared, owned;
  std::vector<std::string> texts;
  auto publisher = room.node->create_publisher<String>("topic", 10);
  auto change = room.node->create_subscription<String>(
    "topic", 10, [&](String::UniquePtr given) {
      owned.push_back(given.get());
      given->data = "changed";
    });
  auto change_shared = room.node->create_subscription<String>(
    "topic", 10, [&](String::SharedPtr given) {
      owned.push_back(given.get());
      given->data = "changed";
    });
  auto read = room.node->create_subscription<String>(
    "topic", 10, [&](const String & given) {
      shared.push_back(&given);
      texts.push_back(given.data);
    });
  auto hold = room.node->create_subscription<String>(
    "topic", 10, [&](String::ConstSharedPtr given) {
      shared.push_back(given.get());
      texts.push_back(given->data);
    });
  publisher->publish(message("a"));
  room.spin_until([&]() {return owned.size() == 2 && shared.size() == 2;});
  EXPECT(shared[0] == shared[1]);
  EXPECT(owned[0] != owned[1] && owned[0] != shared[0] && owned[1] != shared[0]);
  EXPECT(texts == std::vector<std::string>(2, "a"));
}

void the_last_owner_gets_the_message()
{
  Room room;
  std::set<const void *> heard;
  const auto note = [&](String::UniquePtr given) {heard.insert(given.get());};
  std::vector<String::UniquePtr> kept;
  auto first = room.node->create_subscription<String>(
    "topic", 10, [&](String::UniquePtr given) {kept.push_back(std::move(given));});
  auto last = room.node->create_subscription<String>("topic", 10, note);
  auto publisher = room.node->create_publisher<String>("topic", 10);
  auto sent = message("a");
  const void * const address = sent.get();
  publisher->publish(std::move(sent));
  room.spin_until([&]() {return !heard.empty() && !kept.empty();});
  EXPECT(heard.count(address) == 1 && kept[0]->data == "a");
}

/// One at the middleware hears as well, and nobody hears anything twice.
void everybody_once()
{
  Room room;
  std::vector<std::string> here, elsewhere;
  auto publisher = room.node->create_publisher<String>("topic", 10);
  auto local = room.node->create_subscription<String>(
    "topic", 10, [&](String::UniquePtr given) {
      here.push_back(given->data);
      given->data = "changed";
    });
  rclcpp::SubscriptionOptions options;
  options.use_intra_process_comm = IntraProcessSetting::Disable;
  auto remote = room.node->create_subscription<String>(
    "topic", 10, [&](const String & given) {elsewhere.push_back(given.data);}, options);
  room.spin_until([&]() {return publisher->get_subscription_count() == 2;});
  EXPECT(publisher->get_intra_process_subscription_count() == 1);
  for (const char * text : {"a", "b"}) {
    publisher->publish(message(text));
  }
  room.spin_until([&]() {return here.size() >= 2 && elsewhere.size() >= 2;});
  room.spin_a_while();
  EXPECT(here == (std::vector<std::string>{"a", "b"}) && elsewhere == here);
  // A publisher that hands nothing over is heard by way of the middleware.
  rclcpp::PublisherOptions publisher_options;
  publisher_options.use_intra_process_comm = IntraProcessSetting::Disable;
  auto other = room.node->create_publisher<String>("topic", 10, publisher_options);
  room.spin_until([&]() {return other->get_subscription_count() == 2;});
  EXPECT(other->get_intra_process_subscription_count() == 0);
  other->publish(message("c"));
  room.spin_until([&]() {return here.size() == 3 && elsewhere.size() == 3;});
}

void what_is_kept_for_later()
{
  Room room;
  auto publisher = room.node->create_publisher<String>("topic", rclcpp::QoS(2).transient_local());
  for (const char * text : {"a", "b", "c"}) {
    publisher->publish(message(text));
  }
  std::vector<std::string> heard, owned, fresh;
  auto late = room.node->create_subscription<String>(
    "topic", rclcpp::QoS(5).transient_local(), [&](const String & given) {heard.push_back(given.data);});
  auto owner = room.node->create_subscription<String>(
    "topic", rclcpp::QoS(5).transient_local(), [&](String::UniquePtr given) {
      owned.push_back(given->data);
      given->data = "changed";
    });
  auto volatile_one = room.node->create_subscription<String>(
    "topic", 5, [&](const String & given) {fresh.push_back(given.data);});
  room.spin_until([&]() {return heard.size() >= 2 && owned.size() >= 2;});
  room.spin_a_while();
  EXPECT(heard == (std::vector<std::string>{"b", "c"}) && owned == heard && fresh.empty());
}

void only_the_latest()
{
  Room room;
  std::vector<std::string> heard;
  auto publisher = room.node->create_publisher<String>("topic", 10);
  auto subscription = room.node->create_subscription<String>(
    "topic", 2, [&](const String & given) {heard.push_back(given.data);});
  for (const char * text : {"a", "b", "c", "d"}) {
    publisher->publish(message(text));
  }
  room.spin_until([&]() {return heard.size() >= 2;});
  room.spin_a_while();
  EXPECT(heard == (std::vector<std::string>{"c", "d"}));
}

void who_does_not_fit()
{
  Room room;
  auto publisher = room.node->create_publisher<String>("topic", rclcpp::QoS(1).best_effort());
  auto demanding = room.node->create_subscription<String>("topic", 1, [](const String &) {});
  auto other_name = room.node->create_subscription<String>(
    "other", rclcpp::QoS(1).best_effort(), [](const String &) {});
  EXPECT(publisher->get_intra_process_subscription_count() == 0);
  const auto wrong = [&]() {room.node->create_publisher<String>("topic", rclcpp::QoS(rclcpp::KeepAll()));};
  EXPECT(
    THROWN(std::invalid_argument, wrong()) ==
    "intraprocess communication on topic '/topic' allowed only with keep last history qos policy");
  const auto never = [](const String &) {};
  EXPECT(
    !THROWN(
      std::invalid_argument,
      room.node->create_subscription<String>("topic", rclcpp::QoS(rclcpp::KeepAll()), never)).empty());
  EXPECT(
    THROWN(std::runtime_error, publisher->publish(rclcpp::SerializedMessage())) ==
    "storing serialized messages in intra process is not supported yet");
}

/// Many threads publish, many take, and each message is heard once.
void many_threads()
{
  auto node = std::make_shared<rclcpp::Node>("node", rclcpp::NodeOptions().use_intra_process_comms(true));
  auto publisher = node->create_publisher<String>("topic", 1000);
  std::atomic<int> shared{0}, owned{0};
  rclcpp::SubscriptionOptions options;
  options.callback_group = node->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
  auto first = node->create_subscription<String>("topic", 1000, [&](const String &) {++shared;}, options);
  auto second = node->create_subscription<String>("topic", 1000, [&](String::UniquePtr) {++owned;});
  rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 4);
  executor.add_node(node);
  std::thread spinning([&]() {executor.spin();});
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back(
      [&]() {
        for (int j = 0; j < 100; ++j) {
          publisher->publish(message("a"));
        }
      });
  }
  for (auto & thread : threads) {
    thread.join();
  }
  const auto limit = std::chrono::steady_clock::now() + 60s;
  while ((shared < 300 || owned < 300) && std::chrono::steady_clock::now() < limit) {
    std::this_thread::sleep_for(10ms);
  }
  executor.cancel();
  spinning.join();
  EXPECT(shared == 300 && owned == 300);
}

}  // namespace

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const Cases cases{
    {"the_message_itself", the_message_itself},
    {"who_shares_and_who_owns", who_shares_and_who_owns},
    {"the_last_owner_gets_the_message", the_last_owner_gets_the_message},
    {"everybody_once", everybody_once},
    {"what_is_kept_for_later", what_is_kept_for_later},
    {"only_the_latest", only_the_latest},
    {"who_does_not_fit", who_does_not_fit},
    {"many_threads", many_threads},
  };
  const int code = run_case(cases, argv[1]);
  rclcpp::shutdown();
  return code;
}
