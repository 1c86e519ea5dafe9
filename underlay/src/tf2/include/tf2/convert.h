#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rosidl_runtime_cpp/traits.hpp"
#include "tf2/exceptions.h"
#include "tf2/transform_datatypes.h"

namespace tf2
{

// Packages such as tf2_geometry_msgs specialize the first three, and overload `toMsg` and `fromMsg`.

template<class T>
void doTransform(const T & data_in, T & data_out, const geometry_msgs::msg::TransformStamped & transform);

template<class T>
TimePoint getTimestamp(const T & t);

template<class T>
std::string getFrameId(const T & t);

template<class T>
std::array<std::array<double, 6>, 6> getCovarianceMatrix(const T & t);

template<class P>
TimePoint getTimestamp(const Stamped<P> & t) {return t.stamp_;}

template<class P>
std::string getFrameId(const Stamped<P> & t) {return t.frame_id_;}

template<class P>
std::array<std::array<double, 6>, 6> getCovarianceMatrix(const WithCovarianceStamped<P> & t)
{
  return t.cov_mat_;
}

template<typename A, typename B>
B toMsg(const A & a);

template<typename A, typename B>
void fromMsg(const A & a, B & b);

/// Between a message and another type, or between two other types that have the same message.
template<class A, class B>
void convert(const A & a, B & b)
{
  constexpr bool from_message = rosidl_generator_traits::is_message<A>::value;
  constexpr bool to_message = rosidl_generator_traits::is_message<B>::value;
  static_assert(!(from_message && to_message), "two types of messages: specialize tf2::convert for them");
  if constexpr (from_message) {
    fromMsg(a, b);
  } else if constexpr (to_message) {
    b = toMsg(a);
  } else {
    fromMsg(toMsg(a), b);
  }
}

template<class A>
void convert(const A & a1, A & a2)
{
  a2 = a1;
}

/// Six rows of six, one after the other, and as nested arrays.
inline std::array<std::array<double, 6>, 6> covarianceRowMajorToNested(const std::array<double, 36> & row_major)
{
  std::array<std::array<double, 6>, 6> nested;
  for (std::size_t row = 0; row < 6; ++row) {
    std::copy_n(row_major.begin() + 6 * row, 6, nested[row].begin());
  }
  return nested;
}

inline std::array<double, 36> covarianceNestedToRowMajor(const std::array<std::array<double, 6>, 6> & nested_array)
{
  std::array<double, 36> row_major;
  for (std::size_t row = 0; row < 6; ++row) {
    std::copy(nested_array[row].begin(), nested_array[row].end(), row_major.begin() + 6 * row);
  }
  return row_major;
}

}  // namespace tf2
