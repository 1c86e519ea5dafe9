#include "tf2/buffer_core.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <tuple>
#include <utility>

#include "frame_tree.hpp"
#include "rcutils/logging_macros.h"

namespace tf2
{

using geometry_msgs::msg::TransformStamped;

namespace
{

constexpr TransformableRequestHandle NEVER = 0xffffffffffffffffULL;
constexpr int WARNING_INTERVAL = 2500;  // ms
constexpr double LENGTH_TOLERANCE = 10e-3;

struct Request
{
  TransformableRequestHandle handle;
  std::string target, source;
  TimePoint time;
  BufferCore::TransformableCallback callback;
};

std::string without_slash(const std::string & name)
{
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

/// Empty, if the name may be that of a frame.
std::string fault_of(const std::string & name)
{
  return name.empty() ? "in tf2 frame_ids cannot be empty" :
         name.front() == '/' ? "in tf2 frame_ids cannot start with a '/'" : "";
}

FrameId required(const FrameTree & tree, const std::string & name, const std::string & function)
{
  const std::string fault = fault_of(name);
  if (!fault.empty()) {
    throw InvalidArgumentException("Invalid argument \"" + name + "\" passed to " + function + " - " + fault);
  }
  const FrameId id = tree.find(name);
  if (!id) {
    throw LookupException("\"" + name + "\" passed to " + function + " does not exist. ");
  }
  return id;
}

/// 0 if it is not known; that is told, or else logged.
FrameId wanted(
  const FrameTree & tree, const std::string & name, const std::string & function, std::string * error)
{
  std::string fault = fault_of(name);
  const FrameId id = fault.empty() ? tree.find(name) : 0;
  if (id) {
    return id;
  }
  if (fault.empty()) {
    fault = "frame does not exist";
  }
  const std::string text = "Invalid frame ID \"" + name + "\" passed to " + function + " - " + fault;
  if (error) {
    *error = text;
  } else {
    RCUTILS_LOG_WARN_THROTTLE(RCUTILS_STEADY_TIME, WARNING_INTERVAL, "%s", text.c_str());
  }
  return 0;
}

bool is_connected(
  const FrameTree & tree, FrameId target, FrameId source, TimePoint time, std::string * error)
{
  try {
    tree.lookup(target, source, time);
    return true;
  } catch (const TransformException & exception) {
    if (error) {
      *error = exception.what();
    }
    return false;
  }
}

FrameTree::Found look_up(
  const FrameTree & tree, const std::string & target, const std::string & source, TimePoint time)
{
  if (target == source) {  // it need not exist
    const bool latest = time == TimePointZero;
    const FrameId id = tree.find(target);
    return {Transform::getIdentity(), latest ? tree.latest_common_time(id, id) : time};
  }
  const FrameId target_id = required(tree, target, "lookupTransform argument target_frame");
  return tree.lookup(target_id, required(tree, source, "lookupTransform argument source_frame"), time);
}

TransformStamped message_of(
  const FrameTree::Found & found, const std::string & target, const std::string & source)
{
  TransformStamped message;
  const auto stamp = found.stamp.time_since_epoch();
  const auto seconds = std::chrono::floor<std::chrono::seconds>(stamp);
  message.header.stamp.sec = static_cast<std::int32_t>(seconds.count());
  message.header.stamp.nanosec = static_cast<std::uint32_t>((stamp - seconds).count());
  message.header.frame_id = target;
  message.child_frame_id = source;
  const Vector3 & origin = found.transform.getOrigin();
  message.transform.translation.x = origin.x();
  message.transform.translation.y = origin.y();
  message.transform.translation.z = origin.z();
  const Quaternion rotation = found.transform.getRotation();
  message.transform.rotation.x = rotation.x();
  message.transform.rotation.y = rotation.y();
  message.transform.rotation.z = rotation.z();
  message.transform.rotation.w = rotation.w();
  return message;
}

Placement placement_of(const TransformStamped & message)
{
  const auto & [translation, rotation] =
    std::tie(message.transform.translation, message.transform.rotation);
  // The matrix in between gives the rotation its length.
  const Transform transform(Quaternion(rotation.x, rotation.y, rotation.z, rotation.w));
  return {
    TimePoint(
      std::chrono::seconds(message.header.stamp.sec) +
      std::chrono::nanoseconds(message.header.stamp.nanosec)),
    transform.getRotation(), {translation.x, translation.y, translation.z}};
}

/// Logs what makes no sense; false if there is something.
bool makes_sense(
  const Placement & placement, const std::string & parent, const std::string & child,
  const std::string & authority)
{
  const auto & [q, v] = std::tie(placement.rotation, placement.translation);
  bool sense = true;
  if (child == parent) {
    RCUTILS_LOG_ERROR(
      "TF_SELF_TRANSFORM: Ignoring transform from authority \"%s\" with frame_id and  child_frame_id \"%s\" "
      "because they are the same", authority.c_str(), child.c_str());
    sense = false;
  }
  if (child.empty()) {
    RCUTILS_LOG_ERROR(
      "TF_NO_CHILD_FRAME_ID: Ignoring transform from authority \"%s\" because child_frame_id not set ",
      authority.c_str());
    sense = false;
  }
  if (parent.empty()) {
    RCUTILS_LOG_ERROR(
      "TF_NO_FRAME_ID: Ignoring transform with child_frame_id \"%s\"  from authority \"%s\" because frame_id "
      "not set", child.c_str(), authority.c_str());
    sense = false;
  }
  if (std::isnan(v.x() + v.y() + v.z() + q.x() + q.y() + q.z() + q.w())) {
    RCUTILS_LOG_ERROR(
      "TF_NAN_INPUT: Ignoring transform for child_frame_id \"%s\" from authority \"%s\" because of a nan value "
      "in the transform (%f %f %f) (%f %f %f %f)", child.c_str(), authority.c_str(),
      v.x(), v.y(), v.z(), q.x(), q.y(), q.z(), q.w());
    sense = false;
  }
  if (!(std::abs(q.length2() - 1) < LENGTH_TOLERANCE)) {
    RCUTILS_LOG_ERROR(
      "TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id \"%s\" from authority \"%s\" because "
      "of an invalid quaternion in the transform (%f %f %f %f)", child.c_str(), authority.c_str(),
      q.x(), q.y(), q.z(), q.w());
    sense = false;
  }
  return sense;
}

}  // namespace

struct BufferCore::Impl
{
  explicit Impl(Duration cache_time) : kept(cache_time), tree(cache_time) {}

  const Duration kept;
  mutable std::mutex mutex;
  FrameTree tree;
  std::atomic_bool filled_by_thread{false};

  // Taken before the other one.
  std::mutex requests_mutex;
  std::vector<Request> requests;
  TransformableRequestHandle last_handle = 0;

  bool is_possible(const Request & request) const;
  bool is_too_late(const Request & request) const;
  void answer_requests();
};

bool BufferCore::Impl::is_possible(const Request & request) const
{
  const std::lock_guard lock(mutex);
  const FrameId target = tree.find(request.target), source = tree.find(request.source);
  return target && source && is_connected(tree, target, source, request.time, nullptr);
}

bool BufferCore::Impl::is_too_late(const Request & request) const
{
  const std::lock_guard lock(mutex);
  const FrameId target = tree.find(request.target), source = tree.find(request.source);
  if (!target || !source || !is_connected(tree, target, source, TimePointZero, nullptr)) {
    return false;
  }
  const TimePoint latest = tree.latest_common_time(target, source);
  return latest != TimePointZero && request.time + kept < latest;
}

void BufferCore::Impl::answer_requests()
{
  std::vector<std::pair<Request, TransformableResult>> answered;
  {
    const std::lock_guard lock(requests_mutex);
    std::vector<Request> left;
    for (auto & request : requests) {
      const bool possible = is_possible(request);
      if (possible || is_too_late(request)) {
        answered.emplace_back(std::move(request), possible ? TransformAvailable : TransformFailure);
      } else {
        left.push_back(std::move(request));
      }
    }
    requests.swap(left);
  }
  for (const auto & [request, result] : answered) {
    request.callback(request.handle, request.target, request.source, request.time, result);
  }
}

BufferCore::BufferCore(Duration cache_time) : impl_(std::make_unique<Impl>(cache_time)) {}

BufferCore::~BufferCore() = default;

void BufferCore::clear()
{
  const std::lock_guard lock(impl_->mutex);
  impl_->tree.clear();
}

bool BufferCore::setTransform(
  const TransformStamped & transform, const std::string & authority, bool is_static)
{
  const std::string parent = without_slash(transform.header.frame_id);
  const std::string child = without_slash(transform.child_frame_id);
  Placement placement = placement_of(transform);
  if (!makes_sense(placement, parent, child, authority)) {
    return false;
  }
  {
    const std::lock_guard lock(impl_->mutex);
    const FrameId id = impl_->tree.find_or_add(child);
    placement.parent = impl_->tree.find_or_add(parent);
    if (!impl_->tree.insert(id, placement, authority, is_static)) {
      RCUTILS_LOG_WARN(
        "TF_OLD_DATA ignoring data from the past for frame %s at time %s according to authority %s\n"
        "Possible reasons are listed at http://wiki.ros.org/tf/Errors%%20explained",
        child.c_str(), displayTimePoint(placement.stamp).c_str(), authority.c_str());
      return false;
    }
  }
  impl_->answer_requests();
  return true;
}

TransformStamped BufferCore::lookupTransform(
  const std::string & target_frame, const std::string & source_frame, const TimePoint & time) const
{
  const std::lock_guard lock(impl_->mutex);
  return message_of(look_up(impl_->tree, target_frame, source_frame, time), target_frame, source_frame);
}

TransformStamped BufferCore::lookupTransform(
  const std::string & target_frame, const TimePoint & target_time, const std::string & source_frame,
  const TimePoint & source_time, const std::string & fixed_frame) const
{
  const std::lock_guard lock(impl_->mutex);
  const auto & tree = impl_->tree;
  required(tree, target_frame, "lookupTransform argument target_frame");
  required(tree, source_frame, "lookupTransform argument source_frame");
  required(tree, fixed_frame, "lookupTransform argument fixed_frame");
  const auto to_fixed = look_up(tree, fixed_frame, source_frame, source_time);
  const auto to_target = look_up(tree, target_frame, fixed_frame, target_time);
  return message_of(
    {to_target.transform * to_fixed.transform, to_target.stamp}, target_frame, source_frame);
}

bool BufferCore::canTransform(
  const std::string & target_frame, const std::string & source_frame, const TimePoint & time,
  std::string * error_msg) const
{
  if (target_frame == source_frame) {
    return true;
  }
  const std::lock_guard lock(impl_->mutex);
  const auto & tree = impl_->tree;
  const FrameId target = wanted(tree, target_frame, "canTransform argument target_frame", error_msg);
  const FrameId source =
    target ? wanted(tree, source_frame, "canTransform argument source_frame", error_msg) : 0;
  return source && is_connected(tree, target, source, time, error_msg);
}

bool BufferCore::canTransform(
  const std::string & target_frame, const TimePoint & target_time, const std::string & source_frame,
  const TimePoint & source_time, const std::string & fixed_frame, std::string * error_msg) const
{
  const std::lock_guard lock(impl_->mutex);
  const auto & tree = impl_->tree;
  const FrameId target = wanted(tree, target_frame, "canTransform argument target_frame", error_msg);
  const FrameId source =
    target ? wanted(tree, source_frame, "canTransform argument source_frame", error_msg) : 0;
  const FrameId fixed =
    source ? wanted(tree, fixed_frame, "canTransform argument fixed_frame", error_msg) : 0;
  const auto connected = [&tree, error_msg](FrameId to, FrameId from, TimePoint time) {
      return to == from || is_connected(tree, to, from, time, error_msg);
    };
  return fixed && connected(target, fixed, target_time) && connected(fixed, source, source_time);
}

std::vector<std::string> BufferCore::getAllFrameNames() const
{
  const std::lock_guard lock(impl_->mutex);
  return impl_->tree.names();
}

std::string BufferCore::allFramesAsYAML(TimePoint current_time) const
{
  const std::lock_guard lock(impl_->mutex);
  return impl_->tree.as_yaml(current_time);
}

std::string BufferCore::allFramesAsYAML() const {return allFramesAsYAML(TimePointZero);}

std::string BufferCore::allFramesAsString() const
{
  const std::lock_guard lock(impl_->mutex);
  return impl_->tree.as_string();
}

TransformableRequestHandle BufferCore::addTransformableRequest(
  const TransformableCallback & cb, const std::string & target_frame, const std::string & source_frame,
  TimePoint time)
{
  // Held throughout, so that no answer comes in between.
  const std::lock_guard lock(impl_->requests_mutex);
  Request request{impl_->last_handle + 1, target_frame, source_frame, time, cb};
  if (target_frame == source_frame || impl_->is_possible(request)) {
    return 0;
  }
  if (impl_->is_too_late(request)) {
    return NEVER;
  }
  impl_->requests.push_back(std::move(request));
  return ++impl_->last_handle;
}

void BufferCore::cancelTransformableRequest(TransformableRequestHandle handle)
{
  const std::lock_guard lock(impl_->requests_mutex);
  auto & requests = impl_->requests;
  requests.erase(
    std::remove_if(
      requests.begin(), requests.end(),
      [handle](const Request & request) {return request.handle == handle;}),
    requests.end());
}

void BufferCore::setUsingDedicatedThread(bool value) {impl_->filled_by_thread = value;}

bool BufferCore::isUsingDedicatedThread() const {return impl_->filled_by_thread;}

Duration BufferCore::getCacheLength() const {return impl_->kept;}

bool BufferCore::_frameExists(const std::string & frame_id_str) const
{
  const std::lock_guard lock(impl_->mutex);
  return impl_->tree.find(frame_id_str) != 0;
}

bool BufferCore::_getParent(const std::string & frame_id, TimePoint time, std::string & parent) const
{
  const std::lock_guard lock(impl_->mutex);
  const FrameId found = impl_->tree.parent(impl_->tree.find(frame_id), time);
  if (found) {
    parent = impl_->tree.name(found);
  }
  return found != 0;
}

void BufferCore::_getFrameStrings(std::vector<std::string> & ids) const {ids = getAllFrameNames();}

}  // namespace tf2
