#pragma once

#include <array>
#include <string>

#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/point32.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "geometry_msgs/msg/pose.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/pose_with_covariance.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/quaternion.hpp"
#include "geometry_msgs/msg/quaternion_stamped.hpp"
#include "geometry_msgs/msg/transform.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/vector3.hpp"
#include "geometry_msgs/msg/vector3_stamped.hpp"
#include "tf2/LinearMath/Quaternion.h"
#include "tf2/LinearMath/Transform.h"
#include "tf2/LinearMath/Vector3.h"
#include "tf2/convert.h"
#include "tf2_ros/buffer_interface.h"

namespace tf2
{

// ---- messages as types of tf2, and back

inline geometry_msgs::msg::Vector3 toMsg(const Vector3 & in)
{
  geometry_msgs::msg::Vector3 out;
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Vector3 & in, Vector3 & out) {out = {in.x, in.y, in.z};}

inline geometry_msgs::msg::Point & toMsg(const Vector3 & in, geometry_msgs::msg::Point & out)
{
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Point & in, Vector3 & out) {out = {in.x, in.y, in.z};}

inline geometry_msgs::msg::Point32 & toMsg(const Vector3 & in, geometry_msgs::msg::Point32 & out)
{
  out.x = static_cast<float>(in.x());
  out.y = static_cast<float>(in.y());
  out.z = static_cast<float>(in.z());
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Point32 & in, Vector3 & out) {out = {in.x, in.y, in.z};}

inline geometry_msgs::msg::Quaternion toMsg(const Quaternion & in)
{
  geometry_msgs::msg::Quaternion out;
  out.x = in.x();
  out.y = in.y();
  out.z = in.z();
  out.w = in.w();
  return out;
}
inline void fromMsg(const geometry_msgs::msg::Quaternion & in, Quaternion & out)
{
  out = {in.x, in.y, in.z, in.w};
}

inline geometry_msgs::msg::Transform toMsg(const Transform & in)
{
  geometry_msgs::msg::Transform out;
  out.translation = toMsg(in.getOrigin());
  out.rotation = toMsg(in.getRotation());
  return out;
}
inline void toMsg(const Transform & in, geometry_msgs::msg::Transform & out) {out = toMsg(in);}
inline void fromMsg(const geometry_msgs::msg::Transform & in, Transform & out)
{
  Quaternion rotation;
  fromMsg(in.rotation, rotation);
  fromMsg(in.translation, out.getOrigin());
  out.setRotation(rotation);
}

inline void toMsg(const Transform & in, geometry_msgs::msg::Pose & out)
{
  toMsg(in.getOrigin(), out.position);
  out.orientation = toMsg(in.getRotation());
}
inline void fromMsg(const geometry_msgs::msg::Pose & in, Transform & out)
{
  Quaternion rotation;
  fromMsg(in.orientation, rotation);
  fromMsg(in.position, out.getOrigin());
  out.setRotation(rotation);
}

inline geometry_msgs::msg::QuaternionStamped toMsg(const Stamped<Quaternion> & in)
{
  geometry_msgs::msg::QuaternionStamped out;
  out.header.stamp = tf2_ros::toMsg(in.stamp_);
  out.header.frame_id = in.frame_id_;
  out.quaternion = toMsg(static_cast<const Quaternion &>(in));
  return out;
}
inline void fromMsg(const geometry_msgs::msg::QuaternionStamped & in, Stamped<Quaternion> & out)
{
  out.stamp_ = tf2_ros::fromMsg(in.header.stamp);
  out.frame_id_ = in.header.frame_id;
  fromMsg(in.quaternion, static_cast<Quaternion &>(out));
}

inline geometry_msgs::msg::TransformStamped toMsg(const Stamped<Transform> & in)
{
  geometry_msgs::msg::TransformStamped out;
  out.header.stamp = tf2_ros::toMsg(in.stamp_);
  out.header.frame_id = in.frame_id_;
  out.transform = toMsg(static_cast<const Transform &>(in));
  return out;
}
inline void fromMsg(const geometry_msgs::msg::TransformStamped & in, Stamped<Transform> & out)
{
  out.stamp_ = tf2_ros::fromMsg(in.header.stamp);
  out.frame_id_ = in.header.frame_id;
  fromMsg(in.transform, static_cast<Transform &>(out));
}

inline geometry_msgs::msg::PoseWithCovarianceStamped toMsg(const WithCovarianceStamped<Transform> & in)
{
  geometry_msgs::msg::PoseWithCovarianceStamped out;
  out.header.stamp = tf2_ros::toMsg(in.stamp_);
  out.header.frame_id = in.frame_id_;
  out.pose.covariance = covarianceNestedToRowMajor(in.cov_mat_);
  toMsg(static_cast<const Transform &>(in), out.pose.pose);
  return out;
}
inline void fromMsg(
  const geometry_msgs::msg::PoseWithCovarianceStamped & in, WithCovarianceStamped<Transform> & out)
{
  out.stamp_ = tf2_ros::fromMsg(in.header.stamp);
  out.frame_id_ = in.header.frame_id;
  out.cov_mat_ = covarianceRowMajorToNested(in.pose.covariance);
  fromMsg(in.pose.pose, static_cast<Transform &>(out));
}

// ---- from frame to frame; `data_in` and `data_out` may be the same

namespace impl
{

inline Transform transformOf(const geometry_msgs::msg::TransformStamped & message)
{
  Transform transform;
  fromMsg(message.transform, transform);
  return transform;
}

/// How sure it is, along and around the axes of the other frame.
inline std::array<double, 36> turnedCovariance(const std::array<double, 36> & row_major, const Matrix3x3 & turn)
{
  const auto nested = covarianceRowMajorToNested(row_major);
  std::array<std::array<double, 6>, 6> turned;
  for (int row : {0, 3}) {
    for (int column : {0, 3}) {
      Matrix3x3 block;
      for (int i = 0; i < 3; ++i) {
        block[i] = {nested[row + i][column], nested[row + i][column + 1], nested[row + i][column + 2]};
      }
      block = turn * block * turn.transpose();
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          turned[row + i][column + j] = block[i][j];
        }
      }
    }
  }
  return covarianceNestedToRowMajor(turned);
}

}  // namespace impl

template<>
inline void doTransform(
  const geometry_msgs::msg::Vector3 & data_in, geometry_msgs::msg::Vector3 & data_out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  Vector3 v;
  fromMsg(data_in, v);
  data_out = toMsg(impl::transformOf(transform).getBasis() * v);  // it has a direction, but no place
}

template<>
inline void doTransform(
  const geometry_msgs::msg::Point & data_in, geometry_msgs::msg::Point & data_out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  Vector3 v;
  fromMsg(data_in, v);
  toMsg(impl::transformOf(transform) * v, data_out);
}

template<>
inline void doTransform(
  const geometry_msgs::msg::Point32 & data_in, geometry_msgs::msg::Point32 & data_out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  Vector3 v;
  fromMsg(data_in, v);
  toMsg(impl::transformOf(transform) * v, data_out);
}

template<>
inline void doTransform(
  const geometry_msgs::msg::Quaternion & data_in, geometry_msgs::msg::Quaternion & data_out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  Quaternion turn, q;
  fromMsg(transform.transform.rotation, turn);
  fromMsg(data_in, q);
  data_out = toMsg(turn * q);
}

template<>
inline void doTransform(
  const geometry_msgs::msg::Transform & data_in, geometry_msgs::msg::Transform & data_out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  Transform t;
  fromMsg(data_in, t);
  data_out = toMsg(impl::transformOf(transform) * t);
}

template<>
inline void doTransform(
  const geometry_msgs::msg::Pose & data_in, geometry_msgs::msg::Pose & data_out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  Transform t;
  fromMsg(data_in, t);
  toMsg(impl::transformOf(transform) * t, data_out);
}

template<>
inline void doTransform(
  const geometry_msgs::msg::PoseWithCovariance & data_in, geometry_msgs::msg::PoseWithCovariance & data_out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  doTransform(data_in.pose, data_out.pose, transform);
  data_out.covariance = impl::turnedCovariance(data_in.covariance, impl::transformOf(transform).getBasis());
}

template<>
inline std::array<std::array<double, 6>, 6> getCovarianceMatrix(const geometry_msgs::msg::PoseWithCovariance & t)
{
  return covarianceRowMajorToNested(t.covariance);
}

template<>
inline std::array<std::array<double, 6>, 6> getCovarianceMatrix(
  const geometry_msgs::msg::PoseWithCovarianceStamped & t)
{
  return getCovarianceMatrix(t.pose);
}

// A message with a header: its data is in `field`.
#define TF2_GEOMETRY_MSGS_STAMPED(Message, field) \
  template<> \
  inline TimePoint getTimestamp(const geometry_msgs::msg::Message & t) \
  { \
    return tf2_ros::fromMsg(t.header.stamp); \
  } \
  template<> \
  inline std::string getFrameId(const geometry_msgs::msg::Message & t) {return t.header.frame_id;} \
  template<> \
  inline void doTransform( \
    const geometry_msgs::msg::Message & data_in, geometry_msgs::msg::Message & data_out, \
    const geometry_msgs::msg::TransformStamped & transform) \
  { \
    doTransform(data_in.field, data_out.field, transform); \
    data_out.header.stamp = transform.header.stamp; \
    data_out.header.frame_id = transform.header.frame_id; \
  } \
  inline geometry_msgs::msg::Message toMsg(const geometry_msgs::msg::Message & in) {return in;} \
  inline void fromMsg(const geometry_msgs::msg::Message & in, geometry_msgs::msg::Message & out) {out = in;}

TF2_GEOMETRY_MSGS_STAMPED(Vector3Stamped, vector)
TF2_GEOMETRY_MSGS_STAMPED(PointStamped, point)
TF2_GEOMETRY_MSGS_STAMPED(QuaternionStamped, quaternion)
TF2_GEOMETRY_MSGS_STAMPED(PoseStamped, pose)
TF2_GEOMETRY_MSGS_STAMPED(PoseWithCovarianceStamped, pose)
TF2_GEOMETRY_MSGS_STAMPED(TransformStamped, transform)

#undef TF2_GEOMETRY_MSGS_STAMPED

}  // namespace tf2
