#include <sas_conversions/DQ_geometry_msgs_conversions.hpp>

namespace sas
{

namespace
{

/// From and to what has x, y and z.
template<typename Message>
DQ to_dq(const Message & message)
{
  return DQ(0.0, message.x, message.y, message.z);
}

template<typename Message>
void fill(Message & message, const DQ & dq)
{
  message.x = dq.q(1);
  message.y = dq.q(2);
  message.z = dq.q(3);
}

template<typename Message>
Message stamped_now()
{
  Message message;
  message.header.stamp = rclcpp::Clock().now();
  return message;
}

}  // namespace

DQ geometry_msgs_point_to_dq(const geometry_msgs::msg::Point & msg)
{
  return to_dq(msg);
}

geometry_msgs::msg::Point dq_to_geometry_msgs_point(const DQ & dq)
{
  geometry_msgs::msg::Point point;
  fill(point, dq);
  return point;
}

DQ geometry_msgs_point_stamped_to_dq(const geometry_msgs::msg::PointStamped & msg)
{
  return geometry_msgs_point_to_dq(msg.point);
}

geometry_msgs::msg::PointStamped dq_to_geometry_msgs_point_stamped(const DQ & dq)
{
  auto message = stamped_now<geometry_msgs::msg::PointStamped>();
  message.point = dq_to_geometry_msgs_point(dq);
  return message;
}

DQ geometry_msgs_pose_to_dq(const geometry_msgs::msg::Pose & msg)
{
  const DQ rotation = geometry_msgs_quaternion_to_dq(msg.orientation);
  return rotation + 0.5 * E_ * geometry_msgs_point_to_dq(msg.position) * rotation;
}

geometry_msgs::msg::Pose dq_to_geometry_msgs_pose(const DQ & dq)
{
  geometry_msgs::msg::Pose pose;
  pose.position = dq_to_geometry_msgs_point(dq.translation());
  pose.orientation = dq_to_geometry_msgs_quaternion(dq.rotation());
  return pose;
}

DQ geometry_msgs_pose_stamped_to_dq(const geometry_msgs::msg::PoseStamped & msg)
{
  return geometry_msgs_pose_to_dq(msg.pose);
}

geometry_msgs::msg::PoseStamped dq_to_geometry_msgs_pose_stamped(const DQ & dq)
{
  auto message = stamped_now<geometry_msgs::msg::PoseStamped>();
  message.pose = dq_to_geometry_msgs_pose(dq);
  return message;
}

DQ geometry_msgs_quaternion_to_dq(const geometry_msgs::msg::Quaternion & msg)
{
  return DQ(msg.w, msg.x, msg.y, msg.z).normalize();
}

geometry_msgs::msg::Quaternion dq_to_geometry_msgs_quaternion(const DQ & dq)
{
  geometry_msgs::msg::Quaternion quaternion;
  quaternion.w = dq.q(0);
  fill(quaternion, dq);
  return quaternion;
}

void geometry_msgs_wrench_to_dq(const geometry_msgs::msg::Wrench & msg, DQ & force, DQ & torque)
{
  force = to_dq(msg.force);
  torque = to_dq(msg.torque);
}

geometry_msgs::msg::Wrench dq_to_geometry_msgs_wrench(const DQ & force, const DQ & torque)
{
  geometry_msgs::msg::Wrench wrench;
  fill(wrench.force, force);
  fill(wrench.torque, torque);
  return wrench;
}

void geometry_msgs_wrench_stamped_to_dq(
  const geometry_msgs::msg::WrenchStamped & msg, DQ & force, DQ & torque)
{
  geometry_msgs_wrench_to_dq(msg.wrench, force, torque);
}

geometry_msgs::msg::WrenchStamped dq_to_geometry_msgs_wrench_stamped(const DQ & force, const DQ & torque)
{
  auto message = stamped_now<geometry_msgs::msg::WrenchStamped>();
  message.wrench = dq_to_geometry_msgs_wrench(force, torque);
  return message;
}

void geometry_msgs_twist_to_dq(const geometry_msgs::msg::Twist & msg, DQ & linear, DQ & angular)
{
  linear = to_dq(msg.linear);
  angular = to_dq(msg.angular);
}

geometry_msgs::msg::Twist dq_to_geometry_msgs_twist(const DQ & linear, const DQ & angular)
{
  geometry_msgs::msg::Twist twist;
  fill(twist.linear, linear);
  fill(twist.angular, angular);
  return twist;
}

}  // namespace sas
