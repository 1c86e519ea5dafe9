#include "sensors.hpp"

#include <iostream>
#include <string>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "Give a sensor and a cosine: ./bounds 2 0.5\n";
    return 2;
  }
  const std::vector<double> ranges{0.0, 0.5, 1.0, 1.5, 2.0, 2.5};
  const std::size_t sensor = std::stoul(argv[1]);
  const double cosine = std::stod(argv[2]);

  // TODO 3: catch the exception of range_of, and print "sensor 9: no such sensor".
  const double range = range_of(ranges, sensor);
  std::cout << "sensor " << sensor << ": " << range << '\n';

  // TODO 4: catch the exception of tilt_of, and print "tilt: not a number".
  const double tilt = tilt_of(cosine);
  std::cout << "tilt: " << tilt << '\n';

  return 0;
}
