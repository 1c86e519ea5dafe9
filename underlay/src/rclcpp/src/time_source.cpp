#include "rclcpp/time_source.hpp"

#include <algorithm>
#include <future>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "rclcpp/detail/qos_parameters.hpp"
#include "rclcpp/detail/check.hpp"
#include "rclcpp/executors/single_threaded_executor.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/node_interfaces/node_time_source_interface.hpp"

namespace rclcpp
{

namespace
{

using ClockMessage = rosgraph_msgs::msg::Clock;
using node_interfaces::NodeBaseInterface;
using node_interfaces::NodeParametersInterface;
constexpr auto sim_time = "use_sim_time";

bool is_ros_clock(const Clock::SharedPtr & clock)
{
  return clock->get_clock_type() == RCL_ROS_TIME;
}

/// Switches a ROS clock between its own time and `simulated`.
void set_clock(Clock & clock, bool active, const builtin_interfaces::msg::Time & simulated)
{
  if (clock.get_clock_type() != RCL_ROS_TIME) {
    return;
  }
  const std::lock_guard lock(clock.get_clock_mutex());
  rcl_clock_t * const handle = clock.get_clock_handle();
  bool was_active = false;
  detail::check(rcl_is_enabled_ros_time_override(handle, &was_active), "Failed to read the clock");
  if (active && !was_active) {
    detail::check(rcl_enable_ros_time_override(handle), "Failed to enable ROS time");
  } else if (!active && was_active) {
    detail::check(rcl_disable_ros_time_override(handle), "Failed to disable ROS time");
  }
  const auto time = active ? Time(simulated).nanoseconds() : 0;
  detail::check(rcl_set_ros_time_override(handle, time), "Failed to set ROS time");
}

}  // namespace

namespace detail
{

/// What calls back for /clock alone.
class ClockThread
{
public:
  ClockThread(const NodeBaseInterface::SharedPtr & node, const CallbackGroup::SharedPtr & group)
  : executor_(options_for(node))
  {
    executor_.add_callback_group(group, node);
    thread_ = std::thread(
      [this, ended = ended_.get_future().share()]() {executor_.spin_until_future_complete(ended);});
  }
  ClockThread(const ClockThread &) = delete;
  ClockThread & operator=(const ClockThread &) = delete;
  ~ClockThread()
  {
    ended_.set_value();
    executor_.cancel();
    thread_.join();
  }

private:
  static ExecutorOptions options_for(const NodeBaseInterface::SharedPtr & node)
  {
    ExecutorOptions options;
    options.context = node->get_context();
    return options;
  }

  executors::SingleThreadedExecutor executor_;
  std::promise<void> ended_;
  std::thread thread_;
};

}  // namespace detail

/// Callbacks refer to it weakly.
struct TimeSource::Impl : std::enable_shared_from_this<Impl>
{
  Impl(const QoS & qos, bool use_clock_thread) : qos(qos), use_clock_thread(use_clock_thread) {}

  void attach(const NodeBaseInterface::SharedPtr & node, const NodeParametersInterface::SharedPtr & parameters);
  void detach();
  void attach_clock(const Clock::SharedPtr & clock);
  void set_active(bool active);
  void hear(const ClockMessage & message);
  void listen();
  bool all_are_ros_clocks();
  void set_clocks();
  rcl_interfaces::msg::SetParametersResult may_set(const std::vector<Parameter> & parameters);
  void was_set(const std::vector<Parameter> & parameters);

  const QoS qos;
  bool use_clock_thread;

  std::mutex mutex;  // for these
  std::vector<Clock::SharedPtr> clocks;
  bool is_active = false;
  builtin_interfaces::msg::Time time;

  NodeBaseInterface::WeakPtr base;
  NodeParametersInterface::WeakPtr parameters;
  node_interfaces::OnSetParametersCallbackHandle::SharedPtr on_set;
  node_interfaces::PostSetParametersCallbackHandle::SharedPtr post_set;
  CallbackGroup::SharedPtr group;
  Subscription<ClockMessage>::SharedPtr subscription;
  std::unique_ptr<detail::ClockThread> thread;
};

void TimeSource::Impl::attach(
  const NodeBaseInterface::SharedPtr & node, const NodeParametersInterface::SharedPtr & of_node)
{
  base = node;
  parameters = of_node;
  if (!of_node->has_parameter(sim_time)) {
    of_node->declare_parameter(sim_time, ParameterValue(false));
  }
  const auto given = of_node->get_parameter(sim_time);
  if (given.get_type() != PARAMETER_BOOL) {
    RCLCPP_ERROR(
      get_node_logger(node->get_rcl_node_handle()),
      "Invalid type '%s' for parameter 'use_sim_time', should be 'bool'", given.get_type_name().c_str());
    throw std::invalid_argument("Invalid type for parameter 'use_sim_time', should be 'bool'");
  }
  set_active(given.as_bool());
  on_set = of_node->add_on_set_parameters_callback(
    [known = weak_from_this()](const std::vector<Parameter> & changed) {
      const auto self = known.lock();
      return self ? self->may_set(changed) :
             rcl_interfaces::msg::SetParametersResult().set__successful(true);
    });
  post_set = of_node->add_post_set_parameters_callback(
    [known = weak_from_this()](const std::vector<Parameter> & changed) {
      if (const auto self = known.lock()) {
        self->was_set(changed);
      }
    });
}

void TimeSource::Impl::detach()
{
  on_set.reset();
  post_set.reset();
  thread.reset();
  subscription.reset();
  group.reset();
}

rcl_interfaces::msg::SetParametersResult TimeSource::Impl::may_set(
  const std::vector<Parameter> & changed)
{
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  for (const auto & parameter : changed) {
    const bool is_on =
      parameter.get_name() == sim_time && parameter.get_type() == PARAMETER_BOOL && parameter.as_bool();
    if (is_on && !all_are_ros_clocks()) {
      result.successful = false;
      result.reason = "use_sim_time parameter can't be true while clocks are not all of RCL_ROS_TIME type";
      RCLCPP_ERROR(rclcpp::get_logger("rclcpp"), "%s", result.reason.c_str());
    }
  }
  return result;
}

void TimeSource::Impl::was_set(const std::vector<Parameter> & changed)
{
  for (const auto & parameter : changed) {
    if (parameter.get_name() != sim_time) {
      continue;
    }
    if (parameter.get_type() == PARAMETER_BOOL) {
      set_active(parameter.as_bool());
    } else if (parameter.get_type() != PARAMETER_NOT_SET) {
      RCLCPP_ERROR(
        rclcpp::get_logger("rclcpp"), "use_sim_time parameter cannot be set to anything but a bool");
    }
  }
}

void TimeSource::Impl::attach_clock(const Clock::SharedPtr & clock)
{
  std::unique_lock lock(mutex);
  if (is_active && !is_ros_clock(clock)) {
    throw std::invalid_argument(
            "ros_time_active_ can't be true while clock is not of RCL_ROS_TIME type");
  }
  clocks.push_back(clock);
  const auto [active, now] = std::pair(is_active, time);
  lock.unlock();
  set_clock(*clock, active, now);
}

bool TimeSource::Impl::all_are_ros_clocks()
{
  const std::lock_guard lock(mutex);
  return std::all_of(clocks.begin(), clocks.end(), is_ros_clock);
}

void TimeSource::Impl::set_clocks()
{
  std::unique_lock lock(mutex);
  const auto to_set = clocks;
  const auto [active, now] = std::pair(is_active, time);
  lock.unlock();
  for (const auto & clock : to_set) {
    set_clock(*clock, active, now);  // calls handlers of jumps, which may do anything
  }
}

void TimeSource::Impl::set_active(bool active)
{
  {
    const std::lock_guard lock(mutex);
    if (active == is_active) {
      return;
    }
    is_active = active;
  }
  set_clocks();
  if (active) {
    listen();
  } else {
    subscription.reset();  // the thread goes on: it may want the parameters, which the caller has
  }
}

void TimeSource::Impl::listen()
{
  const auto node = base.lock();
  const auto of_node = parameters.lock();
  if (!node || !of_node) {
    return;
  }
  const auto profile = detail::overridden_qos(
    *of_node, node->resolve_topic_or_service_name("/clock", false), "subscription", qos,
    {QosPolicyKind::Depth, QosPolicyKind::Durability, QosPolicyKind::History, QosPolicyKind::Reliability});
  const auto callback = [known = weak_from_this()](const ClockMessage & message) {
      if (const auto self = known.lock()) {
        self->hear(message);
      }
    };
  if (use_clock_thread && !group) {
    group = node->create_callback_group(CallbackGroupType::MutuallyExclusive, false);
  }
  subscription = std::make_shared<Subscription<ClockMessage>>(
    node, "/clock", profile, detail::message_handler<ClockMessage>(callback), SubscriptionOptions());
  node->add(subscription, group);
  if (group && !thread) {
    thread = std::make_unique<detail::ClockThread>(node, group);
  }
}

void TimeSource::Impl::hear(const ClockMessage & message)
{
  {
    const std::lock_guard lock(mutex);
    time = message.clock;
    if (!is_active) {
      return;
    }
  }
  set_clocks();
}

TimeSource::TimeSource(std::shared_ptr<Node> node, const QoS & qos, bool use_clock_thread)
: TimeSource(qos, use_clock_thread)
{
  attachNode(std::move(node));
}

TimeSource::TimeSource(const QoS & qos, bool use_clock_thread)
: qos_(qos), constructed_use_clock_thread_(use_clock_thread),
  impl_(std::make_shared<Impl>(qos, use_clock_thread))
{
}

TimeSource::~TimeSource()
{
  if (impl_) {
    impl_->detach();  // here, and not where a callback lets go of it: the thread cannot wait for itself
  }
}

void TimeSource::attach(
  const NodeBaseInterface::SharedPtr & node, const NodeParametersInterface::SharedPtr & parameters)
{
  impl_->detach();
  impl_->attach(node, parameters);
}

void TimeSource::attachNode(std::shared_ptr<Node> node)
{
  set_use_clock_thread(node->get_node_options().use_clock_thread());
  attach(node->get_node_base_interface(), node->get_node_parameters_interface());
}

void TimeSource::attachNode(
  NodeBaseInterface::SharedPtr node_base_interface, node_interfaces::NodeTopicsInterface::SharedPtr,
  node_interfaces::NodeGraphInterface::SharedPtr, node_interfaces::NodeServicesInterface::SharedPtr,
  node_interfaces::NodeLoggingInterface::SharedPtr, node_interfaces::NodeClockInterface::SharedPtr,
  NodeParametersInterface::SharedPtr node_parameters_interface)
{
  attach(node_base_interface, node_parameters_interface);
}

void TimeSource::detachNode()
{
  impl_->detach();
  impl_->set_active(false);
  impl_ = std::make_shared<Impl>(qos_, constructed_use_clock_thread_);
}

void TimeSource::attachClock(Clock::SharedPtr clock)
{
  impl_->attach_clock(clock);
}

void TimeSource::detachClock(Clock::SharedPtr clock)
{
  const std::lock_guard lock(impl_->mutex);
  auto & clocks = impl_->clocks;
  const auto found = std::find(clocks.begin(), clocks.end(), clock);
  if (found == clocks.end()) {
    RCLCPP_ERROR(get_logger("rclcpp"), "failed to remove clock");
  } else {
    clocks.erase(found);
  }
}

bool TimeSource::get_use_clock_thread()
{
  return impl_->use_clock_thread;
}

void TimeSource::set_use_clock_thread(bool use_clock_thread)
{
  impl_->use_clock_thread = use_clock_thread;
}

bool TimeSource::clock_thread_is_joinable()
{
  return impl_->thread != nullptr;
}

node_interfaces::NodeTimeSourceInterface::NodeTimeSourceInterface(
  const NodeBaseInterface::SharedPtr & node, const NodeParametersInterface::SharedPtr & parameters,
  const Clock::SharedPtr & clock, const QoS & qos, bool use_clock_thread)
: time_source_(qos, use_clock_thread)
{
  time_source_.attach(node, parameters);
  time_source_.attachClock(clock);
}

}  // namespace rclcpp
