#include "hardware.hpp"

#include <iostream>
#include <string>

int main() {
  auto body = make_part("body");
  auto mast = make_part("mast");
  auto sensor = make_part("sensor");
  mount(mast, body);
  mount(sensor, mast);

  std::cout << "the sensor is mounted on the " << parent_of(sensor)->name << '\n';
  std::cout << "the rover has " << parts_from(body) << " parts\n";

  const std::string label = "mast on a " + body->name;
  std::cout << label << '\n';

  return 0;
}
