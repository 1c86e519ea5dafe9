// wait_sets CASE: waiting without an executor; 0 when it holds.

#include "rclcpp/rclcpp.hpp"

#include "case.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"

using namespace std::chrono_literals;
using rclcpp::WaitResultKind;
using std_msgs::msg::String;
using std_srvs::srv::Trigger;

namespace
{

using Guard = std::vector<rclcpp::GuardCondition::SharedPtr>;

std::shared_ptr<rclcpp::Node> node()
{
  return std::make_shared<rclcpp::Node>("node");
}

void never(const String &)
{
}

void one_of_several()
{
  auto here = node();
  auto first = here->create_subscription<String>("first", 10, never);
  auto second = here->create_subscription<String>("second", 10, never);
  auto guard = std::make_shared<rclcpp::GuardCondition>();
  rclcpp::WaitSet set({{{first}, {second}}}, Guard{guard});
  EXPECT(set.wait(10ms).kind() == WaitResultKind::Timeout);
  auto publisher = here->create_publisher<String>("second", 10);
  String message;
  message.data = "a";
  publisher->publish(message);
  {
    auto result = set.wait(60s);
    EXPECT(result.kind() == WaitResultKind::Ready);
    const auto & rcl_set = result.get_wait_set().get_rcl_wait_set();
    EXPECT(&result.get_wait_set() == &set && rcl_set.size_of_subscriptions == 2);
    EXPECT(!rcl_set.subscriptions[0] && rcl_set.subscriptions[1] && !rcl_set.guard_conditions[0]);
    EXPECT(result.next_ready_subscription() == second && !result.next_ready_subscription());
  }
  String heard;
  rclcpp::MessageInfo info;
  EXPECT(second->take(heard, info) && heard == message && !second->take(heard, info));
  guard->trigger();
  EXPECT(set.wait(60s).get_wait_set().get_rcl_wait_set().guard_conditions[0]);
  EXPECT(set.wait(0s).kind() == WaitResultKind::Timeout);
}

void timers_services_and_clients()
{
  auto here = node();
  int count = 0;
  auto never_due = here->create_wall_timer(1h, [&]() {count += 100;});
  auto timer = here->create_wall_timer(20ms, [&]() {++count;});
  {
    rclcpp::WaitSet set({}, {}, {never_due, timer});
    auto result = set.wait(60s);
    EXPECT(result.kind() == WaitResultKind::Ready);
    const auto found = result.peek_next_ready_timer();
    EXPECT(found.first == timer && found.second == 1);
    EXPECT(result.peek_next_ready_timer(1).first == timer);
    result.clear_timer_with_index(1);
    EXPECT(!result.peek_next_ready_timer().first);
    EXPECT(!THROWN(std::out_of_range, result.clear_timer_with_index(2)).empty());
  }
  auto service = here->create_service<Trigger>(
    "go", [](const Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) {});
  auto client = here->create_client<Trigger>("go");
  EXPECT(client->wait_for_service(60s));
  rclcpp::WaitSet set({}, {}, {}, {client}, {service});
  auto future = client->async_send_request(std::make_shared<Trigger::Request>());
  {
    auto result = set.wait(60s);
    EXPECT(result.next_ready_service() == service && !result.next_ready_service());
    EXPECT(!result.next_ready_client());
  }
  rmw_request_id_t id;
  Trigger::Request request;
  Trigger::Response response;
  EXPECT(service->take_request(request, id));
  service->send_response(id, response);
  EXPECT(set.wait(60s).next_ready_client() == client);
  EXPECT(client->take_response(response, id) && !client->take_response(response, id));
  client->handle_response(
    std::make_shared<rmw_request_id_t>(id), std::make_shared<Trigger::Response>(response));
  EXPECT(future.wait_for(0s) == std::future_status::ready);
}

void members_come_and_go()
{
  auto here = node();
  rclcpp::WaitSet set;
  EXPECT(set.wait(1s).kind() == WaitResultKind::Empty);
  auto guard = std::make_shared<rclcpp::GuardCondition>();
  auto subscription = here->create_subscription<String>("topic", 10, never);
  auto timer = here->create_wall_timer(1h, []() {});
  set.add_guard_condition(guard);
  set.add_subscription(subscription);
  set.add_timer(timer);
  rclcpp::WaitSet other;
  EXPECT(
    THROWN(std::runtime_error, other.add_guard_condition(guard)) ==
    "guard condition already in use by another wait set");
  EXPECT(!THROWN(std::runtime_error, set.add_guard_condition(guard)).empty());
  EXPECT(!THROWN(std::runtime_error, other.add_subscription(subscription)).empty());
  EXPECT(!THROWN(std::runtime_error, other.add_timer(timer)).empty());
  EXPECT(
    THROWN(std::runtime_error, other.remove_timer(timer)) == "timer not in wait set");
  EXPECT(!THROWN(std::runtime_error, other.remove_guard_condition(guard)).empty());
  EXPECT(!THROWN(std::invalid_argument, set.add_guard_condition(nullptr)).empty());
  EXPECT(!THROWN(std::invalid_argument, set.remove_subscription(nullptr)).empty());
  guard->trigger();
  auto result = set.wait(60s);
  EXPECT(result.kind() == WaitResultKind::Ready);
  set.remove_timer(timer);
  EXPECT(result.kind() == WaitResultKind::Invalid && !result.next_ready_subscription());
  set.remove_guard_condition(guard);
  set.remove_subscription(subscription);
  EXPECT(set.wait(0s).kind() == WaitResultKind::Empty);
  other.add_guard_condition(guard);
  auto early = other.wait(0s);
  EXPECT(
    THROWN(std::runtime_error, early.get_wait_set()) ==
    "cannot access wait set when the result was not ready");
  guard.reset();  // a wait set keeps nothing alive but what the last wait was for
  EXPECT(other.wait(0s).kind() == WaitResultKind::Timeout);
}

void what_is_gone()
{
  rclcpp::WaitSet set;
  auto guard = std::make_shared<rclcpp::GuardCondition>();
  set.add_guard_condition(guard);
  guard.reset();
  EXPECT(set.wait(0s).kind() == WaitResultKind::Empty);
  set.prune_deleted_entities();
  const std::vector<rclcpp::WaitSet::SubscriptionEntry> none;
  EXPECT(!THROWN(std::invalid_argument, rclcpp::WaitSet(none, {}, {}, {}, {}, {}, nullptr)).empty());
  auto context = std::make_shared<rclcpp::Context>();
  EXPECT(
    !THROWN(
      rclcpp::exceptions::RCLInvalidArgument, rclcpp::WaitSet(none, {}, {}, {}, {}, {}, context)).empty());
}

void fixed_members()
{
  auto here = node();
  auto subscription = here->create_subscription<String>("topic", 10, never);
  auto guard = std::make_shared<rclcpp::GuardCondition>();
  using Set = rclcpp::StaticWaitSet<1, 1, 0, 0, 0, 0>;
  Set set(
    std::array<Set::SubscriptionEntry, 1>{{{subscription}}},
    std::array<rclcpp::GuardCondition::SharedPtr, 1>{{guard}});
  const std::weak_ptr<rclcpp::GuardCondition> known = guard;
  guard->trigger();
  guard.reset();
  EXPECT(!known.expired() && set.wait(60s).get_wait_set().get_rcl_wait_set().guard_conditions[0]);
  EXPECT(set.wait(0s).kind() == WaitResultKind::Timeout);
}

/// A member that comes during the wait is waited for.
void changes_during_a_wait()
{
  rclcpp::ThreadSafeWaitSet set;
  auto first = std::make_shared<rclcpp::GuardCondition>();
  auto second = std::make_shared<rclcpp::GuardCondition>();
  set.add_guard_condition(first);
  std::thread other([&]() {
      std::this_thread::sleep_for(100ms);
      set.add_guard_condition(second);
      second->trigger();
    });
  const auto result = set.wait(60s);
  other.join();
  EXPECT(result.kind() == WaitResultKind::Ready);
  const auto & rcl_set = result.get_wait_set().get_rcl_wait_set();
  EXPECT(!rcl_set.guard_conditions[0] && rcl_set.guard_conditions[1]);
  std::thread emptying([&]() {
      std::this_thread::sleep_for(100ms);
      set.remove_guard_condition(first);
      set.remove_guard_condition(second);
    });
  EXPECT(set.wait(1s).kind() == WaitResultKind::Timeout);  // others may add something again
  emptying.join();
}

/// What is handed over within the process makes a wait set ready, too.
void handed_over()
{
  auto here = std::make_shared<rclcpp::Node>("node", rclcpp::NodeOptions().use_intra_process_comms(true));
  auto publisher = here->create_publisher<String>("topic", 10);
  auto subscription = here->create_subscription<String>("topic", 10, never);
  rclcpp::WaitSet set;
  set.add_subscription(subscription);
  EXPECT(set.wait(10ms).kind() == WaitResultKind::Timeout);
  publisher->publish(std::make_unique<String>());
  EXPECT(set.wait(60s).kind() == WaitResultKind::Ready);
  set.remove_subscription(subscription);
  EXPECT(set.wait(0s).kind() == WaitResultKind::Empty);
}

}  // namespace

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const Cases cases{
    {"one_of_several", one_of_several},
    {"timers_services_and_clients", timers_services_and_clients},
    {"members_come_and_go", members_come_and_go},
    {"what_is_gone", what_is_gone},
    {"fixed_members", fixed_members},
    {"changes_during_a_wait", changes_during_a_wait},
    {"handed_over", handed_over},
  };
  const int code = run_case(cases, argv[1]);
  rclcpp::shutdown();
  return code;
}
