#include "rclcpp/qos.hpp"

#include <array>

#include "rclcpp/detail/check.hpp"
#include "rclcpp/logging.hpp"
#include "rmw/error_handling.h"
#include "rmw/qos_profiles.h"
#include "rmw/rmw.h"

namespace rclcpp
{

namespace
{

bool same(const rmw_time_t & left, const rmw_time_t & right)
{
  return left.sec == right.sec && left.nsec == right.nsec;
}

}  // namespace

std::string qos_policy_name_from_kind(rmw_qos_policy_kind_t policy_kind)
{
  switch (policy_kind) {
    case RMW_QOS_POLICY_DURABILITY:
      return "DURABILITY_QOS_POLICY";
    case RMW_QOS_POLICY_DEADLINE:
      return "DEADLINE_QOS_POLICY";
    case RMW_QOS_POLICY_LIVELINESS:
      return "LIVELINESS_QOS_POLICY";
    case RMW_QOS_POLICY_RELIABILITY:
      return "RELIABILITY_QOS_POLICY";
    case RMW_QOS_POLICY_HISTORY:
      return "HISTORY_QOS_POLICY";
    case RMW_QOS_POLICY_LIFESPAN:
      return "LIFESPAN_QOS_POLICY";
    default:
      return "INVALID_QOS_POLICY";
  }
}

QoSInitialization::QoSInitialization(
  rmw_qos_history_policy_t history_policy_arg, std::size_t depth_arg, bool print_depth_warning)
: history_policy(history_policy_arg), depth(depth_arg)
{
  if (history_policy == RMW_QOS_POLICY_HISTORY_KEEP_LAST && depth == 0 && print_depth_warning) {
    RCLCPP_WARN_ONCE(
      get_logger("rclcpp"), "A zero depth with KEEP_LAST doesn't make sense; no data could be stored. "
      "This will be interpreted as SYSTEM_DEFAULT");
  }
}

QoSInitialization QoSInitialization::from_rmw(const rmw_qos_profile_t & rmw_qos)
{
  switch (rmw_qos.history) {
    case RMW_QOS_POLICY_HISTORY_KEEP_ALL:
      return KeepAll();
    case RMW_QOS_POLICY_HISTORY_KEEP_LAST:
    case RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT:
      return KeepLast(rmw_qos.depth, false);
    default:
      return KeepLast(rmw_qos.depth);
  }
}

KeepAll::KeepAll()
: QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_ALL, 0)
{
}

KeepLast::KeepLast(std::size_t depth, bool print_depth_warning)
: QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_LAST, depth, print_depth_warning)
{
}

QoS::QoS(const QoSInitialization & qos_initialization, const rmw_qos_profile_t & initial_profile)
: profile_(initial_profile)
{
  profile_.history = qos_initialization.history_policy;
  profile_.depth = qos_initialization.depth;
}

QoS::QoS(std::size_t history_depth)
: QoS(KeepLast(history_depth))
{
}

QoS & QoS::history(rmw_qos_history_policy_t history)
{
  profile_.history = history;
  return *this;
}

QoS & QoS::history(HistoryPolicy history)
{
  return this->history(static_cast<rmw_qos_history_policy_t>(history));
}

QoS & QoS::keep_last(std::size_t depth)
{
  profile_.depth = depth;
  return history(RMW_QOS_POLICY_HISTORY_KEEP_LAST);
}

QoS & QoS::keep_all()
{
  profile_.depth = 0;
  return history(RMW_QOS_POLICY_HISTORY_KEEP_ALL);
}

QoS & QoS::reliability(rmw_qos_reliability_policy_t reliability)
{
  profile_.reliability = reliability;
  return *this;
}

QoS & QoS::reliability(ReliabilityPolicy reliability)
{
  return this->reliability(static_cast<rmw_qos_reliability_policy_t>(reliability));
}

QoS & QoS::reliable()
{
  return reliability(ReliabilityPolicy::Reliable);
}

QoS & QoS::best_effort()
{
  return reliability(ReliabilityPolicy::BestEffort);
}

QoS & QoS::reliability_best_available()
{
  return reliability(ReliabilityPolicy::BestAvailable);
}

QoS & QoS::durability(rmw_qos_durability_policy_t durability)
{
  profile_.durability = durability;
  return *this;
}

QoS & QoS::durability(DurabilityPolicy durability)
{
  return this->durability(static_cast<rmw_qos_durability_policy_t>(durability));
}

QoS & QoS::durability_volatile()
{
  return durability(DurabilityPolicy::Volatile);
}

QoS & QoS::transient_local()
{
  return durability(DurabilityPolicy::TransientLocal);
}

QoS & QoS::durability_best_available()
{
  return durability(DurabilityPolicy::BestAvailable);
}

QoS & QoS::deadline(rmw_time_t deadline)
{
  profile_.deadline = deadline;
  return *this;
}

QoS & QoS::deadline(const Duration & deadline)
{
  return this->deadline(deadline.to_rmw_time());
}

QoS & QoS::lifespan(rmw_time_t lifespan)
{
  profile_.lifespan = lifespan;
  return *this;
}

QoS & QoS::lifespan(const Duration & lifespan)
{
  return this->lifespan(lifespan.to_rmw_time());
}

QoS & QoS::liveliness(rmw_qos_liveliness_policy_t liveliness)
{
  profile_.liveliness = liveliness;
  return *this;
}

QoS & QoS::liveliness(LivelinessPolicy liveliness)
{
  return this->liveliness(static_cast<rmw_qos_liveliness_policy_t>(liveliness));
}

QoS & QoS::liveliness_lease_duration(rmw_time_t liveliness_lease_duration)
{
  profile_.liveliness_lease_duration = liveliness_lease_duration;
  return *this;
}

QoS & QoS::liveliness_lease_duration(const Duration & liveliness_lease_duration)
{
  return this->liveliness_lease_duration(liveliness_lease_duration.to_rmw_time());
}

QoS & QoS::avoid_ros_namespace_conventions(bool avoid_ros_namespace_conventions)
{
  profile_.avoid_ros_namespace_conventions = avoid_ros_namespace_conventions;
  return *this;
}

HistoryPolicy QoS::history() const
{
  return static_cast<HistoryPolicy>(profile_.history);
}

std::size_t QoS::depth() const
{
  return profile_.depth;
}

ReliabilityPolicy QoS::reliability() const
{
  return static_cast<ReliabilityPolicy>(profile_.reliability);
}

DurabilityPolicy QoS::durability() const
{
  return static_cast<DurabilityPolicy>(profile_.durability);
}

Duration QoS::deadline() const
{
  return Duration::from_rmw_time(profile_.deadline);
}

Duration QoS::lifespan() const
{
  return Duration::from_rmw_time(profile_.lifespan);
}

LivelinessPolicy QoS::liveliness() const
{
  return static_cast<LivelinessPolicy>(profile_.liveliness);
}

Duration QoS::liveliness_lease_duration() const
{
  return Duration::from_rmw_time(profile_.liveliness_lease_duration);
}

bool QoS::avoid_ros_namespace_conventions() const
{
  return profile_.avoid_ros_namespace_conventions;
}

bool operator==(const QoS & left, const QoS & right)
{
  const auto & l = left.get_rmw_qos_profile();
  const auto & r = right.get_rmw_qos_profile();
  return l.history == r.history && l.depth == r.depth && l.reliability == r.reliability &&
         l.durability == r.durability && same(l.deadline, r.deadline) && same(l.lifespan, r.lifespan) &&
         l.liveliness == r.liveliness &&
         same(l.liveliness_lease_duration, r.liveliness_lease_duration) &&
         l.avoid_ros_namespace_conventions == r.avoid_ros_namespace_conventions;
}

bool operator!=(const QoS & left, const QoS & right)
{
  return !(left == right);
}

QoSCheckCompatibleResult qos_check_compatible(const QoS & publisher_qos, const QoS & subscription_qos)
{
  rmw_qos_compatibility_type_t compatibility = RMW_QOS_COMPATIBILITY_ERROR;
  std::array<char, 2048> reason{};
  const rmw_ret_t ret = rmw_qos_profile_check_compatible(
    publisher_qos.get_rmw_qos_profile(), subscription_qos.get_rmw_qos_profile(), &compatibility,
    reason.data(), reason.size());
  if (ret != RMW_RET_OK) {
    const std::string message = rmw_get_error_string().str;
    rmw_reset_error();
    throw exceptions::QoSCheckCompatibleException(message);
  }
  return {static_cast<QoSCompatibility>(compatibility), reason.data()};
}

ClockQoS::ClockQoS(const QoSInitialization & qos_initialization)
: QoS(qos_initialization, rmw_qos_profile_default)
{
  best_effort();
}

SensorDataQoS::SensorDataQoS(const QoSInitialization & qos_initialization)
: QoS(qos_initialization, rmw_qos_profile_sensor_data)
{
}

ParametersQoS::ParametersQoS(const QoSInitialization & qos_initialization)
: QoS(qos_initialization, rmw_qos_profile_parameters)
{
}

ServicesQoS::ServicesQoS(const QoSInitialization & qos_initialization)
: QoS(qos_initialization, rmw_qos_profile_services_default)
{
}

ParameterEventsQoS::ParameterEventsQoS(const QoSInitialization & qos_initialization)
: QoS(qos_initialization, rmw_qos_profile_parameter_events)
{
}

RosoutQoS::RosoutQoS(const QoSInitialization & rosout_qos_initialization)
: QoS(rosout_qos_initialization, rmw_qos_profile_default)
{
  transient_local();
  lifespan(Duration(std::chrono::seconds(10)));
}

SystemDefaultsQoS::SystemDefaultsQoS(const QoSInitialization & qos_initialization)
: QoS(qos_initialization, rmw_qos_profile_system_default)
{
}

BestAvailableQoS::BestAvailableQoS(const QoSInitialization & qos_initialization)
: QoS(qos_initialization, rmw_qos_profile_best_available)
{
}

}  // namespace rclcpp
