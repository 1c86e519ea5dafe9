#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

inline double range_of(const std::vector<double>& ranges, std::size_t sensor) {
  return ranges.at(sensor);
}

inline double tilt_of(double cosine) {
  const double tilt = std::acos(cosine);
  return tilt == tilt ? tilt : throw std::domain_error("not a number");
}
