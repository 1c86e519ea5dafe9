#include "sensors.hpp"

#include <cstdio>
#include <cstdlib>

int main(int, char** argv) {
  const std::vector<double> ranges{0.0, 0.5, 1.0, 1.5, 2.0, 2.5};
  const auto sensor = static_cast<std::size_t>(std::strtoul(argv[1], nullptr, 10));
  try {
    std::printf("sensor %zu: %g\n", sensor, range_of(ranges, sensor));
  } catch (const std::exception&) {
    std::printf("sensor %zu: no such sensor\n", sensor);
  }
  double tilt = std::numeric_limits<double>::quiet_NaN();
  try {
    tilt = tilt_of(std::strtod(argv[2], nullptr));
  } catch (const std::exception&) {
    std::puts("tilt: not a number");
  }
  if (!std::isnan(tilt)) {
    std::printf("tilt: %.4f\n", tilt);
  }
  return EXIT_SUCCESS;
}
