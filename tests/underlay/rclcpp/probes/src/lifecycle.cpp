// lifecycle CASE: nodes with states; 0 when it holds. `lifecycle node` is one for others to change.

#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include "case.hpp"
#include "lifecycle_msgs/msg/transition_event.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
using rclcpp_lifecycle::LifecycleNode;
using rclcpp_lifecycle::State;
using rclcpp_lifecycle::Transition;
using std_msgs::msg::String;
using CallbackReturn = LifecycleNode::CallbackReturn;
using Between = lifecycle_msgs::msg::State;
using Way = lifecycle_msgs::msg::Transition;

namespace
{

/// Publishes all the time, and notes what it is asked to do, from which state.
class Managed : public LifecycleNode
{
public:
  explicit Managed(const std::string & name = "managed", bool communicates = true)
  : LifecycleNode(name, rclcpp::NodeOptions(), communicates) {}

  CallbackReturn on_configure(const State & before) override
  {
    note("configure", before);
    publisher = create_publisher<String>("topic", 10);
    timer = create_wall_timer(10ms, [this]() {publisher->publish(String());});
    return answer;
  }
  CallbackReturn on_activate(const State & before) override
  {
    note("activate", before);
    return LifecycleNode::on_activate(before);
  }
  CallbackReturn on_deactivate(const State & before) override
  {
    note("deactivate", before);
    return LifecycleNode::on_deactivate(before);
  }
  CallbackReturn on_cleanup(const State & before) override
  {
    note("cleanup", before);
    publisher.reset();
    timer.reset();
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_shutdown(const State & before) override
  {
    note("shutdown", before);
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_error(const State & before) override
  {
    note("error", before);
    return after_error;
  }

  void note(const std::string & what, const State & before)
  {
    notes.push_back(what + " " + before.label() + " " + get_current_state().label());
  }

  CallbackReturn answer = CallbackReturn::SUCCESS, after_error = CallbackReturn::SUCCESS;
  std::vector<std::string> notes;
  rclcpp_lifecycle::LifecyclePublisher<String>::SharedPtr publisher;
  rclcpp::TimerBase::SharedPtr timer;
};

void the_whole_life()
{
  auto node = std::make_shared<Managed>();
  EXPECT(node->shared_from_this() == node && std::string(node->get_name()) == "managed");
  EXPECT(node->get_current_state().id() == Between::PRIMARY_STATE_UNCONFIGURED);
  CallbackReturn code = CallbackReturn::ERROR;
  EXPECT(node->configure(code).label() == "inactive" && code == CallbackReturn::SUCCESS);
  EXPECT(!node->publisher->is_activated());
  EXPECT(node->activate().id() == Between::PRIMARY_STATE_ACTIVE && node->publisher->is_activated());
  EXPECT(node->deactivate().label() == "inactive" && !node->publisher->is_activated());
  EXPECT(node->trigger_transition(Transition(Way::TRANSITION_CLEANUP)).label() == "unconfigured");
  EXPECT(
    node->trigger_transition(Way::TRANSITION_UNCONFIGURED_SHUTDOWN, code).label() == "finalized" &&
    code == CallbackReturn::SUCCESS);
  EXPECT(
    node->notes == (std::vector<std::string>{
    "configure unconfigured configuring", "activate inactive activating",
    "deactivate active deactivating", "cleanup inactive cleaningup",
    "shutdown unconfigured shuttingdown"}));
}

void what_does_not_go()
{
  auto node = std::make_shared<Managed>();
  CallbackReturn code = CallbackReturn::SUCCESS;
  EXPECT(node->activate(code).label() == "unconfigured" && code == CallbackReturn::ERROR);
  code = CallbackReturn::SUCCESS;
  EXPECT(node->trigger_transition(99, code).label() == "unconfigured" && code == CallbackReturn::ERROR);
  EXPECT(node->notes.empty());
  node->answer = CallbackReturn::FAILURE;
  EXPECT(node->configure(code).label() == "unconfigured" && code == CallbackReturn::FAILURE);
  node->answer = CallbackReturn::ERROR;
  EXPECT(node->configure(code).label() == "unconfigured" && code == CallbackReturn::ERROR);
  EXPECT(node->notes.back() == "error unconfigured errorprocessing");
  node->after_error = CallbackReturn::FAILURE;
  EXPECT(node->configure().label() == "finalized");
}

void callbacks_instead_of_methods()
{
  auto node = std::make_shared<LifecycleNode>("node");
  EXPECT(node->register_on_configure([](const State &) -> CallbackReturn {throw std::runtime_error("no");}));
  int count = 0;
  EXPECT(
    node->register_on_error(
      [&](const State &) {
        ++count;
        return CallbackReturn::SUCCESS;
      }));
  EXPECT(node->configure().label() == "unconfigured" && count == 1);
  node->register_on_configure([](const State &) {return CallbackReturn::SUCCESS;});
  node->register_on_shutdown([](const State &) {return CallbackReturn::FAILURE;});
  EXPECT(node->configure().label() == "inactive" && node->shutdown().label() == "finalized");
}

void the_table()
{
  auto node = std::make_shared<LifecycleNode>("node", "space");
  const auto here = node->get_available_transitions();
  EXPECT(here.size() == 2 && here[0].label() == "configure" && here[1].label() == "shutdown");
  EXPECT(here[0].start_state().label() == "unconfigured" && here[0].goal_state().label() == "configuring");
  EXPECT(node->get_available_states().size() == 11 && node->get_transition_graph().size() == 25);
  EXPECT(node->count_publishers("/space/node/transition_event") == 1);
  auto silent = std::make_shared<LifecycleNode>("silent", rclcpp::NodeOptions(), false);
  EXPECT(silent->count_publishers("/silent/transition_event") == 1);
  EXPECT(silent->get_service_names_and_types().count("/silent/get_state") == 0);
  EXPECT(node->get_service_names_and_types().count("/space/node/get_state") == 1);
  EXPECT(silent->configure().label() == "inactive");
  EXPECT(State().label() == "unknown" && !THROWN(std::runtime_error, State(1, "")).empty());
  EXPECT(!THROWN(std::runtime_error, Transition(1, "x").start_state()).empty());
  EXPECT(Transition(1, "x", State(2, "y"), State(3, "z")).goal_state().id() == 3);
}

void publishers_and_other_entities()
{
  struct Entity : rclcpp_lifecycle::SimpleManagedEntity {};
  class Node : public LifecycleNode
  {
public:
    Node() : LifecycleNode("node") {add_managed_entity(entity);}
    std::shared_ptr<Entity> entity = std::make_shared<Entity>();
  };
  auto node = std::make_shared<Node>();
  int heard = 0;
  auto publisher = node->create_publisher<String>("topic", rclcpp::QoS(10).transient_local());
  auto subscription = node->create_subscription<String>(
    "topic", rclcpp::QoS(10).transient_local(), [&](const String &) {++heard;});
  std::vector<std::string> events;
  auto listener = node->create_subscription<lifecycle_msgs::msg::TransitionEvent>(
    "~/transition_event", 10, [&](const lifecycle_msgs::msg::TransitionEvent & event) {
      events.push_back(event.start_state.label + " " + event.goal_state.label);
    });
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node->get_node_base_interface());
  const auto limit = std::chrono::steady_clock::now() + 60s;
  while (node->count_subscribers("topic") < 1 || node->count_publishers("~/transition_event") < 1) {
    EXPECT(std::chrono::steady_clock::now() < limit);
  }
  publisher->publish(String());
  publisher->publish(std::make_unique<String>());
  node->configure();
  EXPECT(!node->entity->is_activated());
  node->activate();
  EXPECT(node->entity->is_activated() && publisher->is_activated());
  publisher->publish(String());
  publisher->publish(std::make_unique<String>());
  while (heard < 2 || events.size() < 4) {
    EXPECT(std::chrono::steady_clock::now() < limit);
    executor.spin_once(10ms);
  }
  executor.spin_some();
  EXPECT(heard == 2);
  EXPECT(
    events == (std::vector<std::string>{
    "unconfigured configuring", "configuring inactive", "inactive activating", "activating active"}));
  node->deactivate();
  EXPECT(!node->entity->is_activated() && !publisher->is_activated());
}

struct Released : State
{
  Released() : State(1, "one") {reset();}
};

/// Its timers go on in all states.
struct Timed : LifecycleNode
{
  Timed() : LifecycleNode("timed")
  {
    add_timer_handle(create_wall_timer(10ms, []() {}));
  }
};

void what_others_derive()
{
  const rcl_lifecycle_state_t * const nothing = nullptr;
  EXPECT(THROWN(std::runtime_error, State(nothing)) == "rcl_lifecycle_state_handle is null");
  const Released state;
  EXPECT(THROWN(std::runtime_error, state.id()) == THROWN(std::runtime_error, state.label()));
  const auto node = std::make_shared<Timed>();
  const auto client = rclcpp::create_client<lifecycle_msgs::srv::GetState>(
    node->get_node_base_interface(), node->get_node_graph_interface(), node->get_node_services_interface(),
    "/timed/get_state", rmw_qos_profile_services_default, nullptr);
  EXPECT(client->wait_for_service(60s));
}

}  // namespace

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  if (argv[1] == std::string("node")) {
    auto node = std::make_shared<Managed>();
    rclcpp::spin(node->get_node_base_interface());
    for (const auto & note : node->notes) {
      std::printf("%s\n", note.c_str());
    }
    return 0;
  }
  const Cases cases{
    {"the_whole_life", the_whole_life},
    {"what_does_not_go", what_does_not_go},
    {"callbacks_instead_of_methods", callbacks_instead_of_methods},
    {"the_table", the_table},
    {"publishers_and_other_entities", publishers_and_other_entities},
    {"what_others_derive", what_others_derive},
  };
  const int code = run_case(cases, argv[1]);
  rclcpp::shutdown();
  return code;
}
