#include "sensors.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace {

class NoSuchSensor : public std::out_of_range {
public:
  explicit NoSuchSensor(std::size_t sensor) : std::out_of_range("no sensor " + std::to_string(sensor)) {}
};

}  // namespace

double range_of(const std::vector<double>& ranges, std::size_t sensor) {
  if (sensor >= ranges.size()) {
    throw NoSuchSensor(sensor);
  }
  return ranges[sensor];
}

double tilt_of(double cosine) {
  if (!(cosine >= -1.0 && cosine <= 1.0)) {
    throw std::domain_error("a cosine is between -1 and 1");
  }
  return std::acos(cosine);
}
