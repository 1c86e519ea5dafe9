#pragma once

#include "geometry_msgs/msg/quaternion.hpp"
#include "geometry_msgs/msg/quaternion_stamped.hpp"
#include "tf2/LinearMath/Quaternion.h"
#include "tf2/LinearMath/Transform.h"
#include "tf2/convert.h"

namespace tf2
{

namespace impl
{

inline Quaternion toQuaternion(const Quaternion & q) {return q;}
inline Quaternion toQuaternion(const geometry_msgs::msg::Quaternion & q) {return {q.x, q.y, q.z, q.w};}
inline Quaternion toQuaternion(const geometry_msgs::msg::QuaternionStamped & q)
{
  return toQuaternion(q.quaternion);
}

/// Of whatever has a message.
template<typename T>
Quaternion toQuaternion(const T & t) {return toQuaternion(toMsg(t));}

/// Also of a quaternion whose length is not one.
void getEulerYPR(const Quaternion & q, double & yaw, double & pitch, double & roll);

}  // namespace impl

/// The angles around the fixed axes x (roll), y (pitch) and z (yaw).
template<class A>
void getEulerYPR(const A & a, double & yaw, double & pitch, double & roll)
{
  impl::getEulerYPR(impl::toQuaternion(a), yaw, pitch, roll);
}

template<class A>
double getYaw(const A & a)
{
  double yaw, pitch, roll;
  getEulerYPR(a, yaw, pitch, roll);
  return yaw;
}

template<class A>
A getTransformIdentity()
{
  A identity;
  convert(Transform::getIdentity(), identity);
  return identity;
}

}  // namespace tf2
