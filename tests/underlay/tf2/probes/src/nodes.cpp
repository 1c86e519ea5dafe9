// nodes CASE: nodes of one process that tell each other where frames are; 0 when it holds.

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "case.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "message_filters/pass_through.h"
#include "placed.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/exceptions.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_msgs/srv/frame_graph.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/create_timer_ros.h"
#include "tf2_ros/message_filter.h"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"

using namespace std::chrono_literals;
using geometry_msgs::msg::TransformStamped;
using tf2::TimePointZero;
using tf2::timeFromSec;

namespace
{

constexpr auto LONG = 60s;

/// Spins a node until it is destroyed.
class Spun
{
public:
  explicit Spun(const std::shared_ptr<rclcpp::Node> & node)
  {
    executor_.add_node(node);
    thread_ = std::thread([this] {executor_.spin_until_future_complete(ended_.get_future());});
  }
  ~Spun()
  {
    ended_.set_value();
    executor_.cancel();
    thread_.join();
  }

private:
  rclcpp::executors::SingleThreadedExecutor executor_;
  std::promise<void> ended_;
  std::thread thread_;
};

/// Tells again and again what is where.
class Teller : public rclcpp::Node
{
public:
  explicit Teller(const std::function<std::vector<TransformStamped>()> & what)
  : Node("teller"), broadcaster_(*this), what_(what)
  {
    timer_ = create_wall_timer(10ms, [this] {broadcaster_.sendTransform(what_());});
  }

private:
  tf2_ros::TransformBroadcaster broadcaster_;
  std::function<std::vector<TransformStamped>()> what_;
  rclcpp::TimerBase::SharedPtr timer_;
};

bool soon(const std::function<bool()> & what)
{
  const auto end = std::chrono::steady_clock::now() + LONG;
  while (!what() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(5ms);
  }
  return what();
}

}  // namespace

void hearing()
{
  const auto node = std::make_shared<rclcpp::Node>("hearer");
  const auto statics = std::make_shared<rclcpp::Node>("statics");
  tf2_ros::StaticTransformBroadcaster fixed(statics);
  fixed.sendTransform(placed("robot", "laser", 0, 1));  // before anybody listens
  fixed.sendTransform(std::vector<TransformStamped>{placed("robot", "camera", 0, 2)});
  tf2_ros::Buffer buffer(node->get_clock());
  const tf2_ros::TransformListener listener(buffer);
  EXPECT(buffer.isUsingDedicatedThread());
  EXPECT(buffer.canTransform("robot", "laser", TimePointZero, LONG));
  EXPECT(buffer.canTransform("robot", "camera", TimePointZero));

  const auto teller = std::make_shared<Teller>([] {
        return std::vector<TransformStamped>{placed("world", "robot", 10, 5), placed("world", "moon", 10, 9)};
      });
  const Spun spun(teller);
  EXPECT(is_at(buffer.lookupTransform("world", "laser", timeFromSec(10), LONG), 6, 0));
  EXPECT(is_at(buffer.lookupTransform("moon", "robot", rclcpp::Time(10, 0), 50ms), -4, 0));
  EXPECT(is_at(buffer.lookupTransform("moon", "robot", rclcpp::Time(0)), -4, 0));
  geometry_msgs::msg::PointStamped point;
  point.header.frame_id = "laser";
  point.point.x = 1;
  EXPECT(buffer.transform(point, "world").point.x == 7);
  geometry_msgs::msg::PointStamped out;
  EXPECT(buffer.transform(point, out, "world", 1s).point.x == 7 && out.header.frame_id == "world");
  EXPECT(buffer.transform(point, "robot", timeFromSec(10), "world", 1s).point.x == 2);
  EXPECT(
    buffer.allFramesAsYAML().find("broadcaster: 'Authority undetectable'") != std::string::npos);
}

void spun_by_others()
{
  const auto node = std::make_shared<rclcpp::Node>("hearer");
  tf2_ros::Buffer buffer(node->get_clock());
  const tf2_ros::TransformListener listener(buffer, node, false);
  EXPECT(!buffer.isUsingDedicatedThread());
  std::string error;
  EXPECT(!buffer.canTransform("world", "robot", TimePointZero, 1s, &error));
  EXPECT(error.find("Do not call canTransform or lookupTransform with a timeout unless") == 0);
  const auto teller = std::make_shared<Teller>([] {return std::vector<TransformStamped>{placed("world", "robot", 10, 5)};});
  const Spun teller_spun(teller), spun(node);
  EXPECT(soon([&buffer] {return buffer.canTransform("world", "robot", timeFromSec(10));}));
}

/// With its own thread a listener hears also while nobody spins its node, even in a constructor.
void inside_a_node()
{
  struct Hearer : rclcpp::Node
  {
    Hearer() : Node("hearer"), buffer(get_clock()), listener(buffer, this) {}
    tf2_ros::Buffer buffer;
    tf2_ros::TransformListener listener;
  };
  const auto hearer = std::make_shared<Hearer>();
  const auto statics = std::make_shared<rclcpp::Node>("statics");
  tf2_ros::StaticTransformBroadcaster(statics.get()).sendTransform(placed("robot", "laser", 0, 1));
  tf2_ros::StaticTransformBroadcaster fixed(*statics);
  fixed.sendTransform(placed("robot", "camera", 0, 1));
  EXPECT(is_at(hearer->buffer.lookupTransform("robot", "camera", TimePointZero, LONG), 1, 0));
}

void waiting_in_vain()
{
  const auto node = std::make_shared<rclcpp::Node>("hearer");
  tf2_ros::Buffer buffer(node->get_clock());
  const tf2_ros::TransformListener listener(buffer);
  EXPECT(buffer.setTransform(placed("world", "robot", 10, 5), "test"));
  EXPECT(buffer.setTransform(placed("world", "robot", 11, 5), "test"));
  const auto start = std::chrono::steady_clock::now();
  std::string error;
  EXPECT(!buffer.canTransform("world", "robot", timeFromSec(12), 100ms, &error));
  EXPECT(std::chrono::steady_clock::now() - start >= 100ms);
  EXPECT(error.find("the latest data is at time 11.000000, when looking up") != std::string::npos);
  EXPECT(error.find(". canTransform returned after 0.1") != std::string::npos);
  EXPECT(error.find(" timeout was 0.1.") != std::string::npos);
  EXPECT(!THROWN(tf2::ForwardExtrapolationException, buffer.lookupTransform("world", "robot", rclcpp::Time(12, 0), 20ms)).empty());
  EXPECT(!THROWN(tf2::LookupException, buffer.lookupTransform("world", "moon", TimePointZero, 20ms)).empty());
  EXPECT(
    !THROWN(
      tf2::ForwardExtrapolationException,
      buffer.lookupTransform("world", rclcpp::Time(11, 0), "robot", rclcpp::Time(12, 0), "world", 20ms)).empty());
}

void being_called()
{
  const auto node = std::make_shared<rclcpp::Node>("hearer");
  const Spun spun(node);
  tf2_ros::Buffer buffer(node->get_clock());
  std::atomic_int calls{0};
  const auto note = [&calls](const tf2_ros::TransformStampedFuture &) {++calls;};
  EXPECT(
    THROWN(
      tf2_ros::CreateTimerInterfaceException,
      buffer.waitForTransform("world", "robot", TimePointZero, 1s, note)) ==
    "timer interface not set before call to waitForTransform");
  buffer.setCreateTimerInterface(
    std::make_shared<tf2_ros::CreateTimerROS>(node->get_node_base_interface(), node->get_node_timers_interface()));

  const auto late = buffer.waitForTransform("world", "robot", timeFromSec(11), 30ms, note);
  EXPECT(late.wait_for(LONG) == std::future_status::ready);
  EXPECT(THROWN(tf2::TimeoutException, late.get()) == "Timed out waiting for transform");
  const auto there = buffer.waitForTransform("world", "robot", timeFromSec(11), LONG, note);
  const auto canceled = buffer.waitForTransform("world", "robot", timeFromSec(11), LONG, note);
  buffer.cancel(canceled);
  EXPECT(soon([&calls] {return calls == 1;}) && there.wait_for(0s) == std::future_status::timeout);
  EXPECT(buffer.setTransform(placed("world", "robot", 10, 0), "test"));
  EXPECT(buffer.setTransform(placed("world", "robot", 12, 2), "test"));
  EXPECT(is_at(there.get(), 1, 0) && soon([&calls] {return calls == 2;}));
  EXPECT(!THROWN(std::future_error, canceled.get()).empty());
  EXPECT(is_at(buffer.waitForTransform("world", "robot", rclcpp::Time(11, 0), LONG, note).get(), 1, 0) && calls == 3);
  EXPECT(buffer.setTransform(placed("world", "robot", 100, 0), "test"));
  const auto never = buffer.waitForTransform("world", "robot", timeFromSec(1), LONG, note);
  EXPECT(THROWN(tf2::LookupException, never.get()) == "Failed to transform from robot to world" && calls == 4);
  const auto left = buffer.waitForTransform("world", "robot", timeFromSec(200), 1ms, note);  // when all ends
}

void timers()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  const Spun spun(node);
  tf2_ros::CreateTimerROS timers(node->get_node_base_interface(), node->get_node_timers_interface());
  std::atomic_int calls{0};
  const auto handle = timers.createTimer(node->get_clock(), 5ms, [&calls](const tf2_ros::TimerHandle &) {++calls;});
  EXPECT(soon([&calls] {return calls > 1;}));
  timers.cancel(handle);
  timers.reset(handle);
  timers.remove(handle);
  EXPECT(THROWN(tf2_ros::InvalidTimerHandleException, timers.cancel(handle)) == "Invalid timer handle in cancel()");
  EXPECT(THROWN(tf2_ros::InvalidTimerHandleException, timers.reset(handle)) == "Invalid timer handle in reset()");
  EXPECT(THROWN(tf2_ros::InvalidTimerHandleException, timers.remove(handle)) == "Invalid timer handle in remove()");
  EXPECT(!THROWN(tf2_ros::CreateTimerInterfaceException, timers.createTimer(node->get_clock(), -1s, nullptr)).empty());
}

void jumps()
{
  const auto clock = std::make_shared<rclcpp::Clock>(RCL_ROS_TIME);
  tf2_ros::Buffer buffer(clock);
  const auto show = [&clock](std::int64_t seconds) {
      const std::lock_guard lock(clock->get_clock_mutex());
      return rcl_set_ros_time_override(clock->get_clock_handle(), seconds * 1000000000) == RCL_RET_OK;
    };
  EXPECT(show(100) && rcl_enable_ros_time_override(clock->get_clock_handle()) == RCL_RET_OK);
  EXPECT(buffer.setTransform(placed("world", "robot", 10, 5), "test"));
  EXPECT(show(200) && buffer.canTransform("world", "robot", TimePointZero));
  EXPECT(show(150) && !buffer.canTransform("world", "robot", TimePointZero));
  EXPECT(THROWN(std::invalid_argument, tf2_ros::Buffer(nullptr)) == "clock must be a valid instance");
}

void service()
{
  const auto node = std::make_shared<rclcpp::Node>("hearer");
  tf2_ros::Buffer buffer(node->get_clock(), 10s, node);
  EXPECT(buffer.setTransform(placed("world", "robot", 10, 5), "test"));
  const auto client = node->create_client<tf2_msgs::srv::FrameGraph>("tf2_frames");
  EXPECT(client->wait_for_service(LONG));
  auto future = client->async_send_request(std::make_shared<tf2_msgs::srv::FrameGraph::Request>());
  EXPECT(rclcpp::spin_until_future_complete(node, future, LONG) == rclcpp::FutureReturnCode::SUCCESS);
  EXPECT(future.get()->frame_yaml == buffer.allFramesAsYAML());
}

void quality()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  const tf2_ros::TransformBroadcaster moving(node);
  const tf2_ros::StaticTransformBroadcaster fixed(node);
  tf2_ros::Buffer buffer(node->get_clock());
  const tf2_ros::TransformListener listener(buffer, node, false);
  EXPECT(node->get_parameter("qos_overrides./tf.publisher.depth").as_int() == 100);
  EXPECT(node->get_parameter("qos_overrides./tf.publisher.durability").as_string() == "volatile");
  EXPECT(node->get_parameter("qos_overrides./tf_static.publisher.depth").as_int() == 1);
  EXPECT(node->get_parameter("qos_overrides./tf_static.subscription.depth").as_int() == 100);
  EXPECT(!node->has_parameter("qos_overrides./tf_static.publisher.durability"));
  const auto told = node->get_publishers_info_by_topic("/tf_static");
  EXPECT(told.size() == 1 && told[0].qos_profile().durability() == rclcpp::DurabilityPolicy::TransientLocal);
}

/// Many come and go; each ends, whether its thread has begun or not.
void short_lives()
{
  const auto node = std::make_shared<rclcpp::Node>("node");
  tf2_ros::Buffer buffer(node->get_clock());
  for (int i = 0; i < 50; ++i) {
    const tf2_ros::TransformListener listener(buffer, node);
  }
}

using geometry_msgs::msg::PointStamped;

std::shared_ptr<PointStamped> point(const std::string & frame, double seconds)
{
  const auto made = std::make_shared<PointStamped>();
  made->header = placed(frame, "", seconds, 0).header;
  return made;
}

/// A filter for points in frames that are known, and what it lets through.
struct Filtering
{
  explicit Filtering(unsigned queue_size, std::chrono::milliseconds timeout = LONG)
  : filter(buffer, "world", queue_size, node, timeout)
  {
    buffer.setCreateTimerInterface(
      std::make_shared<tf2_ros::CreateTimerROS>(
        node->get_node_base_interface(), node->get_node_timers_interface()));
    filter.registerCallback(&Filtering::hear, this);
  }
  void hear(const std::shared_ptr<PointStamped const> & one) {heard.push_back(one->header.stamp.sec);}
  void know(double seconds, const std::string & frame = "world")
  {
    buffer.setTransform(placed(frame, "robot", seconds, 1), "test");
  }

  std::shared_ptr<rclcpp::Node> node = std::make_shared<rclcpp::Node>("node");
  tf2_ros::Buffer buffer{node->get_clock()};
  std::vector<int> heard;
  tf2_ros::MessageFilter<PointStamped> filter;
};

/// Messages wait for transforms, and come through in the order in which these become known.
void filtering()
{
  Filtering all(0);
  all.know(1);
  all.filter.add(point("/robot", 1));
  EXPECT(all.heard == std::vector<int>{1});
  all.filter.add(point("robot", 4));
  all.filter.add(point("robot", 2));
  all.filter.add(point("", 1));
  EXPECT(all.heard.size() == 1);
  all.know(3);
  EXPECT(all.heard == std::vector<int>({1, 2}));
  all.know(5);
  EXPECT(all.heard == std::vector<int>({1, 2, 4}));
  all.filter.setTolerance(rclcpp::Duration(2, 0));
  all.filter.add(point("robot", 4));
  all.know(5.5);
  EXPECT(all.heard.size() == 3);
  all.know(6);
  EXPECT(all.heard.size() == 4);
  all.filter.add(point("robot", 8));
  all.filter.clear();
  all.know(20);
  EXPECT(all.heard.size() == 4);
}

void filtering_for_several_frames()
{
  Filtering all(0);
  all.filter.setTargetFrames({"world", "/room"});
  EXPECT(all.filter.getTargetFramesString() == "world room ");
  all.know(1);
  all.filter.add(point("robot", 1));
  EXPECT(all.heard.empty());
  all.buffer.setTransform(placed("world", "room", 1, 1), "test");
  EXPECT(all.heard == std::vector<int>{1});
}

void filtering_has_limits()
{
  Filtering one(1);
  EXPECT(one.filter.getQueueSize() == 1);
  one.filter.add(point("robot", 1));
  one.filter.add(point("robot", 2));
  one.know(1);
  one.know(2);
  EXPECT(one.heard == std::vector<int>{2});
  Filtering brief(0, 20ms);
  const Spun spun(brief.node);
  brief.filter.add(point("robot", 1));
  std::this_thread::sleep_for(1s);
  brief.know(1);
  EXPECT(brief.heard.empty());
}

/// The end of a filter takes its messages with it.
void filtering_ends()
{
  Filtering all(0);
  {
    message_filters::PassThrough<PointStamped> input;
    tf2_ros::MessageFilter<PointStamped> filter(input, all.buffer, "world", 10, all.node);
    filter.registerCallback(&Filtering::hear, &all);
    input.add(point("robot", 1));
    all.know(1);
    EXPECT(all.heard == std::vector<int>{1});
    input.add(point("robot", 2));
  }
  all.know(2);
  EXPECT(all.heard.size() == 1);
}

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const int code = run_case(
  {
    {"hearing", hearing},
    {"spun_by_others", spun_by_others},
    {"inside_a_node", inside_a_node},
    {"waiting_in_vain", waiting_in_vain},
    {"being_called", being_called},
    {"timers", timers},
    {"jumps", jumps},
    {"service", service},
    {"quality", quality},
    {"short_lives", short_lives},
    {"filtering", filtering},
    {"filtering_for_several_frames", filtering_for_several_frames},
    {"filtering_has_limits", filtering_has_limits},
    {"filtering_ends", filtering_ends},
  }, argv[1]);
  rclcpp::shutdown();
  return code;
}
