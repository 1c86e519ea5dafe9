#include "frame_tree.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "tf2/buffer_core.h"

namespace tf2
{

FrameTree::FrameTree(Duration kept)
: kept_(kept), frames_{{"NO_PARENT", std::nullopt, ""}}, ids_{{"NO_PARENT", 0}} {}

FrameId FrameTree::find(const std::string & name) const
{
  const auto found = ids_.find(name);
  return found == ids_.end() ? 0 : found->second;
}

FrameId FrameTree::find_or_add(const std::string & name)
{
  const auto [found, is_new] = ids_.emplace(name, static_cast<FrameId>(frames_.size()));
  if (is_new) {
    frames_.push_back({name, std::nullopt, ""});
  }
  return found->second;
}

std::vector<std::string> FrameTree::names() const
{
  std::vector<std::string> names;
  for (std::size_t id = 1; id < frames_.size(); ++id) {
    names.push_back(frames_[id].name);
  }
  return names;
}

bool FrameTree::insert(
  FrameId child, const Placement & placement, const std::string & authority, bool is_static)
{
  auto & frame = frames_.at(child);
  if (!frame.history || frame.history->is_static() != is_static) {
    frame.history.emplace(is_static, kept_);
  }
  if (!frame.history->insert(placement)) {
    return false;
  }
  frame.authority = authority;
  return true;
}

void FrameTree::clear()
{
  for (auto & frame : frames_) {
    if (frame.history) {
      frame.history->clear();
    }
  }
}

FrameTree::Step FrameTree::above(const Step & step, const Placement & placement)
{
  return {
    placement.parent, placement.rotation * step.rotation,
    quatRotate(placement.rotation, step.translation) + placement.translation};
}

/// Up to the target or, failing that, as far as there is data; `gap` says why it ends before the root.
std::vector<FrameTree::Step> FrameTree::way_up(
  FrameId source, FrameId target, TimePoint time, std::optional<Gap> & gap) const
{
  std::vector<Step> way{{source, Quaternion::getIdentity(), {}}};
  while (way.back().frame != target && frames_.at(way.back().frame).history) {
    Gap found;
    const auto placement = frames_[way.back().frame].history->at(time, found);
    if (!placement) {
      gap = found;
      break;
    }
    way.push_back(above(way.back(), *placement));
    check_depth(way.size());
  }
  return way;
}

FrameTree::Found FrameTree::lookup(FrameId target, FrameId source, TimePoint time) const
{
  if (time == TimePointZero) {
    time = latest_common_time(target, source);
  }
  std::optional<Gap> source_gap;
  const auto way = way_up(source, target, time, source_gap);
  Step step{target, Quaternion::getIdentity(), {}};
  for (std::size_t depth = 0;; check_depth(++depth)) {
    const auto common = std::find_if(
      way.begin(), way.end(), [&step](const Step & other) {return other.frame == step.frame;});
    if (common != way.end()) {
      const Quaternion back = step.rotation.inverse();
      return {
        Transform(back * common->rotation, quatRotate(back, common->translation - step.translation)), time};
    }
    const auto & history = frames_.at(step.frame).history;
    if (!history) {
      break;
    }
    Gap gap;
    const auto placement = history->at(time, gap);
    if (!placement) {
      throw_gap(gap, target, source);
    }
    step = above(step, *placement);
  }
  if (source_gap) {
    throw_gap(*source_gap, target, source);
  }
  throw_unconnected(target, source);
}

TimePoint FrameTree::latest_common_time(FrameId target, FrameId source) const
{
  // Static frames are good for all times.
  const auto earlier = [](TimePoint time, TimePoint stamp) {
      return stamp == TimePointZero ? time : std::min(time, stamp);
    };
  const auto or_zero = [](TimePoint time) {return time == TimePoint::max() ? TimePointZero : time;};
  const auto parent_of = [this](FrameId frame) {
      const auto & history = frames_.at(frame).history;
      return history ? history->latest_parent() : 0;
    };

  if (target == source) {
    const auto & history = frames_.at(target).history;
    return history ? history->latest() : TimePointZero;
  }
  std::vector<std::pair<FrameId, TimePoint>> way{{source, TimePoint::max()}};
  while (way.back().first != target && parent_of(way.back().first)) {
    const auto [frame, time] = way.back();
    way.emplace_back(parent_of(frame), earlier(time, frames_[frame].history->latest()));
    check_depth(way.size());
  }
  FrameId frame = target;
  TimePoint time = TimePoint::max();
  for (std::size_t depth = 0;; check_depth(++depth)) {
    const auto common = std::find_if(
      way.begin(), way.end(), [frame](const auto & other) {return other.first == frame;});
    if (common != way.end()) {
      return or_zero(std::min(time, common->second));
    }
    const FrameId parent = parent_of(frame);
    if (!parent) {
      throw_unconnected(target, source);
    }
    time = earlier(time, frames_[frame].history->latest());
    frame = parent;
  }
}

FrameId FrameTree::parent(FrameId frame, TimePoint time) const
{
  Gap gap;
  const auto & history = frames_.at(frame).history;
  const auto placement = history ? history->at(time, gap) : std::nullopt;
  return placement ? placement->parent : 0;
}

void FrameTree::check_depth(std::size_t depth) const
{
  if (depth > BufferCore::MAX_GRAPH_DEPTH) {
    throw LookupException("The tf tree is invalid because it contains a loop.\n" + as_string() + "\n");
  }
}

void FrameTree::throw_gap(const Gap & gap, FrameId target, FrameId source) const
{
  const std::string text = gap.text + ", when looking up transform from frame [" + name(source) +
    "] to frame [" + name(target) + "]";
  switch (gap.error) {
    case TF2Error::TF2_BACKWARD_EXTRAPOLATION_ERROR:
      throw BackwardExtrapolationException(text);
    case TF2Error::TF2_FORWARD_EXTRAPOLATION_ERROR:
      throw ForwardExtrapolationException(text);
    default:
      throw NoDataForExtrapolationException(text);
  }
}

void FrameTree::throw_unconnected(FrameId target, FrameId source) const
{
  throw ConnectivityException(
    "Could not find a connection between '" + name(target) + "' and '" + name(source) +
    "' because they are not part of the same tree.Tf has two or more unconnected trees.");
}

std::string FrameTree::as_string() const
{
  std::ostringstream text;
  for (const auto & frame : frames_) {
    if (frame.history) {
      text << "Frame " << frame.name << " exists with parent " << name(frame.history->latest_parent()) << ".\n";
    }
  }
  return text.str();
}

std::string FrameTree::as_yaml(TimePoint now) const
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(3);
  if (frames_.size() == 1) {
    text << "[]";
  }
  for (const auto & frame : frames_) {
    if (!frame.history || frame.history->size() == 0) {
      continue;
    }
    const auto & history = *frame.history;
    const Duration length = history.latest() - history.oldest();
    const Duration divisor = std::max<Duration>(length, std::chrono::microseconds(100));
    text << frame.name << ": \n"
         << "  parent: '" << name(history.latest_parent()) << "'\n"
         << "  broadcaster: '" << frame.authority << "'\n"
         << "  rate: " << static_cast<double>(history.size()) / durationToSec(divisor) << "\n"
         << "  most_recent_transform: " << displayTimePoint(history.latest()) << "\n"
         << "  oldest_transform: " << displayTimePoint(history.oldest()) << "\n";
    if (now != TimePointZero) {
      text << "  transform_delay: " << durationToSec(now - history.latest()) << "\n";
    }
    text << "  buffer_length: " << durationToSec(length) << "\n";
  }
  return text.str();
}

}  // namespace tf2
