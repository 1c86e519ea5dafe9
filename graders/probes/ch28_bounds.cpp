// Calls the two functions of 28-bounds with our own numbers. The argument selects the question, because a read
// outside the vector may end the program.
#include "ask.hpp"
#include "ros2_tutorials_preamble/cpp/bounds/sensors.hpp"

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// Says what the function returns, or names the exception if it is the expected one.
template <typename Expected, typename Function>
std::string what_becomes_of(const std::string& name, Function&& function) {
  try {
    return "returned " + std::to_string(function());
  } catch (const Expected&) {
    return name;
  }
}

std::string out_of_range(std::size_t sensor) {
  const std::vector<double> ranges{0.25, 1.5, 3.0};
  return what_becomes_of<std::out_of_range>("out_of_range", [&] { return range_of(ranges, sensor); });
}

std::string domain_error(double cosine) {
  return what_becomes_of<std::domain_error>("domain_error", [&] { return tilt_of(cosine); });
}

}  // namespace

int main(int, char** arguments) {
  const std::string asked = arguments[1];
  if (asked == "ranges") {
    const std::vector<double> ranges{0.25, 1.5, 3.0};
    ask("ranges", [&] {
      return std::vector<double>{range_of(ranges, 0), range_of(ranges, 1), range_of(ranges, 2)};
    });
  } else if (asked == "behind") {
    ask("behind", [] { return out_of_range(3); });
  } else if (asked == "far") {
    ask("far", [] { return out_of_range(std::numeric_limits<std::size_t>::max()); });
  } else {
    ask("tilts", [] {
      return std::vector<double>{tilt_of(1.0), tilt_of(0.5), tilt_of(0.0), tilt_of(-1.0)};
    });
    ask("above", [] { return domain_error(1.1); });
    ask("below", [] { return domain_error(-1.1); });
  }
  done();
  return 0;
}
