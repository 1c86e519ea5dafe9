#include "sensors.hpp"

#include <iostream>
#include <stdexcept>
#include <string>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "Give a sensor and a cosine: ./bounds 2 0.5\n";
    return 2;
  }
  const std::vector<double> ranges{0.0, 0.5, 1.0, 1.5, 2.0, 2.5};
  const std::size_t sensor = std::stoul(argv[1]);
  const double cosine = std::stod(argv[2]);

  try {
    const double range = range_of(ranges, sensor);
    std::cout << "sensor " << sensor << ": " << range << '\n';
  } catch (const std::out_of_range&) {
    std::cout << "sensor " << sensor << ": no such sensor\n";
  }

  try {
    const double tilt = tilt_of(cosine);
    std::cout << "tilt: " << tilt << '\n';
  } catch (const std::domain_error&) {
    std::cout << "tilt: not a number\n";
  }

  return 0;
}
