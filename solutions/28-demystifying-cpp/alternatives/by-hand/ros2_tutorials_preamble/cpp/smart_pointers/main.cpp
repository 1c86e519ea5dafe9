#include "hardware.hpp"

#include <iostream>

int main() {
  auto body = make_part("body");
  auto mast = make_part("mast");
  auto sensor = make_part("sensor");
  mount(mast, body);
  mount(sensor, mast);

  std::cout << "the sensor is mounted on the " << parent_of(sensor)->name << std::endl;
  std::cout << "the rover has " << parts_from(body) << " parts" << std::endl;

  const auto label = std::make_unique<std::string>("mast on a " + body->name);
  std::cout << *label << std::endl;
}
