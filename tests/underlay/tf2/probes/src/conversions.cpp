// conversions CASE: messages as types of tf2, and from frame to frame; 0 when it holds.

#include <string>

#include "case.hpp"
#include "placed.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

using namespace geometry_msgs::msg;  // NOLINT

namespace
{

template<typename MessageT>
MessageT stamped(const std::string & frame)
{
  MessageT message;
  message.header.frame_id = frame;
  message.header.stamp.sec = 5;
  return message;
}

/// A quarter turn to the left, then 10 along x.
const auto WAY = placed("world", "robot", 9, 10, 0, M_PI_2);

template<typename MessageT>
bool came(const MessageT & message)
{
  return message.header.frame_id == "world" && message.header.stamp.sec == 9;
}

template<typename PointT>
bool is(const PointT & point, double x, double y, double z)
{
  return std::abs(point.x - x) < 1e-6 && std::abs(point.y - y) < 1e-6 && std::abs(point.z - z) < 1e-6;
}

}  // namespace

void quaternions()
{
  tf2::Quaternion q, back, again;
  q.setRPY(0.1, 0.2, 0.3);
  const geometry_msgs::msg::Quaternion message = tf2::toMsg(q);
  tf2::convert(message, back);
  tf2::fromMsg(message, again);
  EXPECT(back == q && again == q && message.w == q.w());
  geometry_msgs::msg::Quaternion other;
  tf2::convert(q, other);
  EXPECT(other == message && near(tf2::getYaw(message), 0.3));
  double yaw, pitch, roll;
  tf2::getEulerYPR(message, yaw, pitch, roll);
  EXPECT(near(yaw, 0.3) && near(pitch, 0.2) && near(roll, 0.1));
  auto with_header = stamped<QuaternionStamped>("robot");
  with_header.quaternion = message;
  EXPECT(near(tf2::getYaw(with_header), 0.3));
  tf2::Stamped<tf2::Quaternion> typed;
  tf2::convert(with_header, typed);
  EXPECT(typed == q && typed.frame_id_ == "robot" && typed.stamp_ == tf2::timeFromSec(5));
  EXPECT(tf2::toMsg(typed) == with_header && near(tf2::getYaw(typed), 0.3));
}

void others()
{
  tf2::Vector3 v;
  tf2::fromMsg(tf2::toMsg(tf2::Vector3(1, 2, 3)), v);
  EXPECT(v == tf2::Vector3(1, 2, 3));
  Point point;
  tf2::fromMsg(tf2::toMsg(tf2::Vector3(4, 5, 6), point), v);
  EXPECT(point.y == 5 && v == tf2::Vector3(4, 5, 6));
  tf2::Transform t;
  tf2::fromMsg(WAY.transform, t);
  EXPECT(is(tf2::toMsg(t * tf2::Vector3(1, 0, 0)), 10, 1, 0));
  EXPECT(is(tf2::toMsg(t).translation, 10, 0, 0) && near(tf2::getYaw(tf2::toMsg(t).rotation), M_PI_2));
  Pose pose;
  tf2::toMsg(t, pose);
  tf2::Transform back;
  tf2::fromMsg(pose, back);
  EXPECT(is(pose.position, 10, 0, 0) && near(back.getOrigin().x(), 10));
  tf2::Stamped<tf2::Transform> typed;
  tf2::convert(WAY, typed);
  EXPECT(typed.frame_id_ == "world" && is(tf2::toMsg(typed).transform.translation, 10, 0, 0));
  EXPECT(tf2::getFrameId(WAY) == "world" && tf2::getTimestamp(WAY) == tf2::timeFromSec(9));
  EXPECT(near(tf2::getTransformIdentity<geometry_msgs::msg::Transform>().rotation.w, 1));
  auto same = stamped<PointStamped>("robot"), copy = same;
  copy.header.frame_id = "";
  tf2::convert(same, copy);
  EXPECT(copy == same);
}

void frames()
{
  auto vector = stamped<Vector3Stamped>("robot");
  vector.vector.x = 1;
  tf2::doTransform(vector, vector, WAY);
  EXPECT(is(vector.vector, 0, 1, 0) && came(vector));  // a direction has no place

  auto point = stamped<PointStamped>("robot");
  point.point.x = 1;
  tf2::doTransform(point, point, WAY);
  EXPECT(is(point.point, 10, 1, 0) && came(point));
  Point32 small;
  small.x = 2;
  tf2::doTransform(small, small, WAY);
  EXPECT(is(small, 10, 2, 0));

  auto pose = stamped<PoseStamped>("robot");
  pose.pose.position.y = 1;
  pose.pose.orientation = placed("", "", 0, 0, 0, 0.5).transform.rotation;
  tf2::doTransform(pose, pose, WAY);
  EXPECT(is(pose.pose.position, 9, 0, 0) && near(tf2::getYaw(pose.pose.orientation), M_PI_2 + 0.5) && came(pose));

  auto rotation = stamped<QuaternionStamped>("robot");
  tf2::doTransform(rotation, rotation, WAY);
  EXPECT(near(tf2::getYaw(rotation), M_PI_2) && came(rotation));

  auto transform = placed("robot", "laser", 5, 1, 0, 0.5);
  tf2::doTransform(transform, transform, WAY);
  EXPECT(is_at(transform, 10, 1, M_PI_2 + 0.5) && came(transform));
}

void covariances()
{
  auto pose = stamped<PoseWithCovarianceStamped>("robot");
  pose.pose.pose.position.x = 1;
  for (int i = 0; i < 36; ++i) {
    pose.pose.covariance[i] = i;
  }
  tf2::doTransform(pose, pose, WAY);
  const auto turned = tf2::getCovarianceMatrix(pose);
  // What was along x is along y, what was along y is along -x.
  EXPECT(is(pose.pose.pose.position, 10, 1, 0) && came(pose));
  EXPECT(near(turned[1][1], 0) && near(turned[0][0], 7) && near(turned[1][0], -1) && near(turned[0][1], -6));
  EXPECT(near(turned[2][2], 14) && near(turned[4][4], 21) && near(turned[1][4], 3) && near(turned[0][4], -9));
  tf2::WithCovarianceStamped<tf2::Transform> typed;
  tf2::fromMsg(pose, typed);
  EXPECT(typed.cov_mat_ == turned && tf2::toMsg(typed).pose.covariance == pose.pose.covariance);
}

int main(int, char * argv[])
{
  return run_case(
  {
    {"quaternions", quaternions},
    {"others", others},
    {"frames", frames},
    {"covariances", covariances},
  }, argv[1]);
}
