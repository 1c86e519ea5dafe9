#pragma once

#include <stdexcept>

#include "rclcpp/topic_statistics_state.hpp"

namespace rclcpp::detail
{

/// Whether statistics are taken, by the options of a subscription or else by those of its node.
template<typename OptionsT, typename NodeBaseT>
bool resolve_enable_topic_statistics(const OptionsT & options, const NodeBaseT & node_base)
{
  switch (options.topic_stats_options.state) {
    case TopicStatisticsState::Enable:
      return true;
    case TopicStatisticsState::Disable:
      return false;
    case TopicStatisticsState::NodeDefault:
      return node_base.get_enable_topic_statistics_default();
  }
  throw std::runtime_error("Unrecognized EnableTopicStatistics value");
}

}  // namespace rclcpp::detail
