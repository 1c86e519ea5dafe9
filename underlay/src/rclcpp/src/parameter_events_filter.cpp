#include "rclcpp/parameter_events_filter.hpp"

#include <algorithm>

namespace rclcpp
{

ParameterEventsFilter::ParameterEventsFilter(
  std::shared_ptr<const rcl_interfaces::msg::ParameterEvent> event,
  const std::vector<std::string> & names, const std::vector<EventType> & types)
: event_(std::move(event))
{
  const auto has = [](const auto & all, const auto & one) {
      return std::find(all.begin(), all.end(), one) != all.end();
    };
  const auto add = [&](EventType type, const auto & parameters) {
      for (const auto & parameter : parameters) {
        if (has(types, type) && has(names, parameter.name)) {
          result_.emplace_back(type, &parameter);
        }
      }
    };
  add(EventType::NEW, event_->new_parameters);
  add(EventType::CHANGED, event_->changed_parameters);
  add(EventType::DELETED, event_->deleted_parameters);
}

}  // namespace rclcpp
