#include "link.hpp"

#include <iostream>
#include <string>

int main() {
  auto base = make_link("base");
  auto elbow = make_link("elbow");
  auto hand = make_link("hand");
  mount(elbow, base);
  mount(hand, elbow);

  std::cout << "the hand is mounted on the " << parent_of(hand)->name << '\n';
  std::cout << "the arm has " << links_from(base) << " links\n";

  // TODO 3: this text is never deleted. Does it need `new`?
  std::string* label = new std::string("arm on a " + base->name);
  std::cout << *label << '\n';

  return 0;
}
