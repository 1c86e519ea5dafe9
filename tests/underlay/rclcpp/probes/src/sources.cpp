// sources CASE: what sources of other people use of rclcpp beside the usual; 0 when it holds.

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "class_loader/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"

#include "case.hpp"
#include "rclcpp/any_service_callback.hpp"
#include "rclcpp/node_interfaces/node_interfaces.hpp"
#include "rclcpp/parameter_events_filter.hpp"
#include "rclcpp/strategies/allocator_memory_strategy.hpp"
#include "rclcpp/strategies/message_pool_memory_strategy.hpp"
#include "rclcpp/time_source.hpp"
#include "rclcpp/type_support_decl.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/set_bool.hpp"

using namespace std::chrono_literals;
using ClockMessage = rosgraph_msgs::msg::Clock;
using std_srvs::srv::SetBool;
namespace parts = rclcpp::node_interfaces;

namespace
{

void tell_time(rclcpp::Node & node, rclcpp::Publisher<ClockMessage> & publisher, int seconds)
{
  ClockMessage message;
  message.clock.sec = seconds;
  wait_until([&]() {
      publisher.publish(message);
      return node.now() == rclcpp::Time(seconds, 0, RCL_ROS_TIME);
    });
}

rclcpp::NodeOptions simulated()
{
  return rclcpp::NodeOptions().append_parameter_override("use_sim_time", true);
}

void simulated_time_goes_on_without_spinning()
{
  const auto node = std::make_shared<rclcpp::Node>("node", simulated());
  const auto publisher = node->create_publisher<ClockMessage>("/clock", rclcpp::ClockQoS());
  tell_time(*node, *publisher, 7);
  EXPECT(node->has_parameter("qos_overrides./clock.subscription.depth"));
  node->set_parameter({"use_sim_time", false});
  EXPECT(!node->get_clock()->ros_time_is_active());
  node->set_parameter({"use_sim_time", true});
  tell_time(*node, *publisher, 9);
}

void simulated_time_waits_for_the_executor_without_a_thread()
{
  const auto node = std::make_shared<rclcpp::Node>("node", simulated().use_clock_thread(false));
  const auto publisher = node->create_publisher<ClockMessage>("/clock", rclcpp::ClockQoS());
  wait_until([&]() {return publisher->get_subscription_count() == 1;});
  ClockMessage message;
  message.clock.sec = 5;
  publisher->publish(message);
  std::this_thread::sleep_for(300ms);
  EXPECT(node->now().nanoseconds() == 0);
  wait_until([&]() {
      rclcpp::spin_some(node);
      return node->now().seconds() == 5;
    });
}

void time_source_follows_a_node()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  const auto clock = std::make_shared<rclcpp::Clock>(RCL_ROS_TIME);
  rclcpp::TimeSource source(node);
  source.attachClock(clock);
  EXPECT(!clock->ros_time_is_active() && !source.clock_thread_is_joinable());
  node->set_parameter({"use_sim_time", true});
  EXPECT(clock->ros_time_is_active() && source.clock_thread_is_joinable());
  const auto steady = std::make_shared<rclcpp::Clock>(RCL_STEADY_TIME);
  EXPECT(!THROWN(std::invalid_argument, source.attachClock(steady)).empty());
  source.detachNode();
  EXPECT(!clock->ros_time_is_active() && !source.clock_thread_is_joinable());
}

void only_ros_clocks_are_simulated()
{
  const auto node =
    std::make_shared<rclcpp::Node>("node", rclcpp::NodeOptions().clock_type(RCL_STEADY_TIME));
  const auto result = node->set_parameter({"use_sim_time", true});
  EXPECT(!result.successful && result.reason.find("RCL_ROS_TIME") != std::string::npos);
}

class Doorbell : public rclcpp::Waitable
{
public:
  void ring(int number)
  {
    number_ = number;
    condition_.trigger();
  }
  std::size_t get_number_of_ready_guard_conditions() override {return 1;}
  void add_to_wait_set(rcl_wait_set_t & wait_set) override {condition_.add_to_wait_set(wait_set);}
  bool is_ready(const rcl_wait_set_t & wait_set) override
  {
    const auto * const begin = wait_set.guard_conditions;
    return std::any_of(begin, begin + wait_set.size_of_guard_conditions, [this](const auto * one) {
        return one == &condition_.get_rcl_guard_condition();
      });
  }
  std::shared_ptr<void> take_data() override {return std::make_shared<int>(number_);}
  void execute(const std::shared_ptr<void> & data) override
  {
    heard.push_back(*std::static_pointer_cast<int>(data));
  }

  std::vector<int> heard;

private:
  int number_ = 0;
  rclcpp::GuardCondition condition_;
};

void waitables_in_executors()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  const auto bell = std::make_shared<Doorbell>();
  node->get_node_waitables_interface()->add_waitable(bell, nullptr);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  bell->ring(3);
  executor.spin_once(10s);
  EXPECT(bell->heard == std::vector<int>{3});
  executor.spin_once(0s);
  EXPECT(bell->heard.size() == 1);
  node->get_node_waitables_interface()->remove_waitable(bell, nullptr);
  bell->ring(4);
  executor.spin_some();
  EXPECT(bell->heard.size() == 1);
}

void waitables_in_wait_sets()
{
  const auto bell = std::make_shared<Doorbell>();
  rclcpp::WaitSet set;
  set.add_waitable(bell);
  EXPECT(!THROWN(std::runtime_error, set.add_waitable(bell)).empty());
  EXPECT(set.wait(10ms).kind() == rclcpp::WaitResultKind::Timeout);
  bell->ring(1);
  EXPECT(set.wait(10s).kind() == rclcpp::WaitResultKind::Ready);
  EXPECT(bell->is_ready(set.get_rcl_wait_set()));
  set.remove_waitable(bell);
  EXPECT(set.wait(10ms).kind() == rclcpp::WaitResultKind::Empty);
}

void guard_conditions_call_back()
{
  rclcpp::GuardCondition condition;
  std::vector<std::size_t> counts;
  condition.trigger();
  condition.trigger();
  condition.set_on_trigger_callback([&](std::size_t count) {counts.push_back(count);});
  condition.trigger();
  EXPECT((counts == std::vector<std::size_t>{2, 1}));
}

void timers_by_class()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  int calls = 0;
  const auto call = [&calls]() {++calls;};
  const auto timer = rclcpp::WallTimer<decltype(call)>::make_shared(1ms, call);
  EXPECT(timer->is_steady());
  node->get_node_timers_interface()->add_timer(timer, nullptr);
  wait_until([&]() {
      rclcpp::spin_some(node);
      return calls > 0;
    });
  EXPECT(!THROWN(
    std::invalid_argument,
    rclcpp::create_wall_timer(1ms, call, nullptr, nullptr, node->get_node_timers_interface().get())).empty());
}

void parts_of_nodes()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  EXPECT(parts::get_node_topics_interface(node) == node->get_node_topics_interface());
  EXPECT(parts::get_node_topics_interface(*node) == node->get_node_topics_interface());
  EXPECT(
    parts::get_node_topics_interface(node->get_node_topics_interface()) ==
    node->get_node_topics_interface());
  EXPECT(THROWN(
    std::invalid_argument,
    parts::get_node_base_interface(rclcpp::Node::SharedPtr())) == "node cannot be nullptr");
  static_assert(parts::has_node_base_interface<rclcpp::Node>::value);
  static_assert(!parts::has_node_base_interface<int>::value);
  const parts::NodeInterfaces<ALL_RCLCPP_NODE_INTERFACES> all(*node);
  EXPECT(all.get_node_time_source_interface() && all.get_node_type_descriptions_interface());
}

void parameters_of_files()
{
  const auto folder = std::filesystem::temp_directory_path();
  const std::string file = folder / ("parameters_" + std::to_string(getpid()) + ".yaml");
  std::ofstream(file) << "/**:\n  ros__parameters: {a: 1, b: [x, z]}\n"
                      << "/other:\n  ros__parameters: {c: true}\n";
  const auto map = rclcpp::parameter_map_from_yaml_file(file);
  EXPECT(map.size() == 2 && map.at("/**").size() == 2 && map.at("/other").front().as_bool());
  EXPECT(rclcpp::parameters_from_map(map, "/node").size() == 2);
  EXPECT(rclcpp::parameters_from_map(map, "/other").size() == 3);
  const auto node = std::make_shared<rclcpp::Node>(
    "node", rclcpp::NodeOptions().allow_undeclared_parameters(true));
  const auto client = std::make_shared<rclcpp::SyncParametersClient>(node);
  for (const auto & result : client->load_parameters(file)) {
    EXPECT(result.successful);
  }
  EXPECT(node->get_parameter("a").as_int() == 1 && !node->has_parameter("c"));
  EXPECT(!THROWN(
    rclcpp::exceptions::InvalidParametersException, rclcpp::parameter_map_from(nullptr)).empty());
  rclcpp::AsyncParametersClient others(node, "/nobody");
  EXPECT(THROWN(
    rclcpp::exceptions::InvalidParametersException,
    others.load_parameters(rclcpp::ParameterMap())) == "No valid parameter");
  std::filesystem::remove(file);
}

void parameters_are_copied()
{
  const auto from = std::make_shared<rclcpp::Node>("from"), to = std::make_shared<rclcpp::Node>("to");
  from->declare_parameter("new", 1);
  from->declare_parameter("both", 2);
  to->declare_parameter("both", 3);
  rclcpp::copy_all_parameter_values(from, to);
  EXPECT(to->get_parameter("new").as_int() == 1 && to->get_parameter("both").as_int() == 3);
  rclcpp::copy_all_parameter_values(from, to, true);
  EXPECT(to->get_parameter("both").as_int() == 2);
}

void events_are_filtered()
{
  using Filter = rclcpp::ParameterEventsFilter;
  const auto event = std::make_shared<rcl_interfaces::msg::ParameterEvent>();
  event->new_parameters.push_back(rclcpp::Parameter("a", 1).to_parameter_msg());
  event->changed_parameters.push_back(rclcpp::Parameter("b", 2).to_parameter_msg());
  const Filter filter(event, {"a", "b"}, {Filter::EventType::CHANGED});
  EXPECT(filter.get_events().size() == 1 && filter.get_events().front().second->name == "b");
}

void generic_clients()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  const auto service = node->create_service<SetBool>(
    "switch", [](const SetBool::Request::SharedPtr request, SetBool::Response::SharedPtr response) {
      response->success = request->data;
      response->message = "done";
    });
  const auto client = node->create_generic_client("switch", "std_srvs/srv/SetBool");
  EXPECT(client->wait_for_service(10s));
  SetBool::Request request;
  request.data = true;
  auto future = client->async_send_request(&request);
  EXPECT(rclcpp::spin_until_future_complete(node, future, 10s) == rclcpp::FutureReturnCode::SUCCESS);
  const auto response = std::static_pointer_cast<SetBool::Response>(future.get());
  EXPECT(response->success && response->message == "done");
  EXPECT(!THROWN(
    std::runtime_error, node->create_generic_client("switch", "std_srvs/srv/Nothing")).empty());
}

struct CountingResource
{
  int made = 0, gone = 0;
};

template<typename T>
struct CountingAllocator
{
  using value_type = T;
  explicit CountingAllocator(CountingResource * counts) : resource(counts) {}
  template<typename U>
  CountingAllocator(const CountingAllocator<U> & other) : resource(other.resource) {}  // NOLINT
  T * allocate(std::size_t count)
  {
    ++resource->made;
    return std::allocator<T>().allocate(count);
  }
  void deallocate(T * memory, std::size_t count)
  {
    ++resource->gone;
    std::allocator<T>().deallocate(memory, count);
  }
  CountingResource * resource;
};

void messages_of_an_allocator()
{
  using Message = std_msgs::msg::Int32;
  using Alloc = CountingAllocator<Message>;
  CountingResource counts;
  const auto allocator = std::make_shared<Alloc>(&counts);
  const auto node =
    std::make_shared<rclcpp::Node>("node", rclcpp::NodeOptions().use_intra_process_comms(true));
  rclcpp::PublisherOptionsWithAllocator<Alloc> options;
  options.allocator = allocator;
  const auto publisher = node->create_publisher<Message>("numbers", 10, options);
  int heard = 0;
  const auto subscription =
    node->create_subscription<Message>("numbers", 10, [&](const Message & message) {heard = message.data;});
  Message * const memory = allocator->allocate(1);
  using Deleter = rclcpp::allocator::Deleter<Alloc, Message>;
  publisher->publish(std::unique_ptr<Message, Deleter>(
    new(memory) Message(std_msgs::build<Message>().data(8)), Deleter(allocator.get())));
  wait_until([&]() {
      rclcpp::spin_some(node);
      return heard == 8;
    });
  EXPECT(counts.made == 1 && counts.gone == 1);
}

void a_pool_of_messages()
{
  rclcpp::strategies::message_pool_memory_strategy::MessagePoolMemoryStrategy<std_msgs::msg::Int32, 1> pool;
  auto message = pool.borrow_message();
  EXPECT(THROWN(std::runtime_error, pool.borrow_message()) == "No more free slots in the pool");
  pool.return_message(message);
  message.reset();
  EXPECT(pool.borrow_message() != nullptr);
}

struct Shape
{
  virtual ~Shape() = default;
  virtual int corners() const = 0;
};

struct Square : Shape
{
  int corners() const override {return 4;}
};

CLASS_LOADER_REGISTER_CLASS(Square, Shape)

void classes_by_name()
{
  class_loader::ClassLoader loader("");
  EXPECT(loader.getAvailableClasses<Shape>() == std::vector<std::string>{"Square"});
  EXPECT(loader.createUniqueInstance<Shape>("Square")->corners() == 4);
  EXPECT(!THROWN(class_loader::CreateClassException, loader.createInstance<Shape>("Circle")).empty());
  EXPECT(!THROWN(class_loader::LibraryLoadException, class_loader::ClassLoader("libnothing.so")).empty());
}

void callbacks_of_any_form()
{
  using Any = rclcpp::AnySubscriptionCallback<std_msgs::msg::Int32>;
  const auto shared = std::make_shared<std_msgs::msg::Int32>();
  const rclcpp::MessageInfo info;
  EXPECT(!THROWN(std::runtime_error, (Any().dispatch(shared, info), 0)).empty());
  const void * seen = nullptr;
  auto reads = Any().set([&](const std_msgs::msg::Int32 & message) {seen = &message;});
  reads.dispatch_intra_process(shared, info);
  EXPECT(seen == shared.get() && reads.use_take_shared_method());
  auto keeps = Any().set([&](std::unique_ptr<std_msgs::msg::Int32> message) {seen = message.get();});
  keeps.dispatch_intra_process(shared, info);
  EXPECT(seen != shared.get() && !keeps.use_take_shared_method());
  auto only = std::make_unique<std_msgs::msg::Int32>();
  const void * const given = only.get();
  keeps.dispatch_intra_process(std::move(only), info);
  EXPECT(seen == given && !keeps.is_serialized_message_callback());
  const auto bytes = Any().set([](const rclcpp::SerializedMessage &) {});
  EXPECT(bytes.is_serialized_message_callback());
}

void services_made_by_rcl()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  const auto handle = node->get_node_base_interface()->get_shared_rcl_node_handle();
  rcl_service_t made = rcl_get_zero_initialized_service();
  rclcpp::AnyServiceCallback<SetBool> callback;
  callback.set(
    [](std::shared_ptr<SetBool::Request> request, std::shared_ptr<SetBool::Response> response) {
      response->success = request->data;
    });
  EXPECT(
    THROWN(std::runtime_error, rclcpp::Service<SetBool>(handle, &made, callback)) ==
    "rcl_service_t in constructor argument must be initialized beforehand.");
  const auto options = rcl_service_get_default_options();
  const auto * const type = rosidl_typesupport_cpp::get_service_type_support_handle<SetBool>();
  EXPECT(rcl_service_init(&made, handle.get(), type, "made", &options) == RCL_RET_OK);
  {
    const auto service = std::make_shared<rclcpp::Service<SetBool>>(handle, &made, callback);
    node->get_node_services_interface()->add_service(service, nullptr);
    const auto client = node->create_client<SetBool>("made");
    EXPECT(client->wait_for_service(60s));
    const auto request = std::make_shared<SetBool::Request>();
    request->data = true;
    auto answer = client->async_send_request(request);
    EXPECT(rclcpp::spin_until_future_complete(node, answer, 60s) == rclcpp::FutureReturnCode::SUCCESS);
    EXPECT(answer.get()->success);
  }
  EXPECT(rcl_service_fini(&made, handle.get()) == RCL_RET_OK);
}

void groups_tell_of_what_is_added()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  const auto group = node->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
  std::size_t told = 0;
  group->get_notify_guard_condition()->set_on_trigger_callback([&](std::size_t count) {told += count;});
  const auto timer = node->create_wall_timer(1h, []() {}, group);
  EXPECT(told == 1);
  EXPECT(!rclcpp::CallbackGroup(rclcpp::CallbackGroupType::Reentrant).get_notify_guard_condition());
}

/// A publisher of a type that is known by its support alone.
void publishers_by_options_of_rcl()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  const rclcpp::PublisherOptions options;
  const rclcpp::PublisherBase publisher(
    node->get_node_base_interface().get(), "results",
    *rclcpp::type_support::get_set_parameters_result_msg_type_support(),
    options.to_rcl_publisher_options<std_msgs::msg::Int32>(rclcpp::QoS(3)), options.event_callbacks, true);
  EXPECT(publisher.get_actual_qos().depth() == 3);
  EXPECT(
    node->get_topic_names_and_types().at("/results") ==
    std::vector<std::string>{"rcl_interfaces/msg/SetParametersResult"});
}

}  // namespace

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const Cases cases{
    {"simulated_time_goes_on_without_spinning", simulated_time_goes_on_without_spinning},
    {"simulated_time_waits_for_the_executor_without_a_thread", simulated_time_waits_for_the_executor_without_a_thread},
    {"time_source_follows_a_node", time_source_follows_a_node},
    {"only_ros_clocks_are_simulated", only_ros_clocks_are_simulated},
    {"waitables_in_executors", waitables_in_executors},
    {"waitables_in_wait_sets", waitables_in_wait_sets},
    {"guard_conditions_call_back", guard_conditions_call_back},
    {"timers_by_class", timers_by_class},
    {"parts_of_nodes", parts_of_nodes},
    {"parameters_of_files", parameters_of_files},
    {"parameters_are_copied", parameters_are_copied},
    {"events_are_filtered", events_are_filtered},
    {"generic_clients", generic_clients},
    {"messages_of_an_allocator", messages_of_an_allocator},
    {"a_pool_of_messages", a_pool_of_messages},
    {"classes_by_name", classes_by_name},
    {"callbacks_of_any_form", callbacks_of_any_form},
    {"services_made_by_rcl", services_made_by_rcl},
    {"groups_tell_of_what_is_added", groups_tell_of_what_is_added},
    {"publishers_by_options_of_rcl", publishers_by_options_of_rcl},
  };
  const int code = run_case(cases, argv[1]);
  rclcpp::shutdown();
  return code;
}
