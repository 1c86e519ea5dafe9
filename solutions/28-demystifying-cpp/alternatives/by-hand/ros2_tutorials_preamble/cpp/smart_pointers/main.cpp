#include "link.hpp"

#include <iostream>

int main() {
  auto base = make_link("base");
  auto elbow = make_link("elbow");
  auto hand = make_link("hand");
  mount(elbow, base);
  mount(hand, elbow);

  std::cout << "the hand is mounted on the " << parent_of(hand)->name << std::endl;
  std::cout << "the arm has " << links_from(base) << " links" << std::endl;

  const auto label = std::make_unique<std::string>("arm on a " + base->name);
  std::cout << *label << std::endl;
}
