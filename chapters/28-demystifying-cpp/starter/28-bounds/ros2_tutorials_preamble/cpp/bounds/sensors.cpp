#include "sensors.hpp"

#include <cmath>

double range_of(const std::vector<double>& ranges, std::size_t sensor) {
  // TODO 1: throw std::out_of_range if there is no such sensor.
  return ranges[sensor];
}

double tilt_of(double cosine) {
  // TODO 2: throw std::domain_error if the result is not a number.
  return std::acos(cosine);
}
