#include "sensors.hpp"

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

void print_range(std::size_t sensor) try {
  const std::vector<double> ranges{0.0, 0.5, 1.0, 1.5, 2.0, 2.5};
  const double range = range_of(ranges, sensor);
  std::cout << "sensor " << sensor << ": " << range << std::endl;
} catch (const std::logic_error&) {
  std::cout << "sensor " << sensor << ": no such sensor" << std::endl;
}

void print_tilt(double cosine) try {
  const double tilt = tilt_of(cosine);
  std::cout << "tilt: " << tilt << std::endl;
} catch (...) {
  std::cout << "tilt: not a number" << std::endl;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    return 2;
  }
  print_range(static_cast<std::size_t>(std::stoi(argv[1])));
  print_tilt(std::atof(argv[2]));
}
