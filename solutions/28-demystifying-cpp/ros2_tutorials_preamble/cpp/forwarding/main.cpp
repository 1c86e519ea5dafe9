#include "noisy.hpp"
#include "things.hpp"

#include <iostream>

int main() {
  std::cout << "make\n";
  const auto one = make<Noisy>(20.0);

  std::cout << "append\n";
  std::vector<Noisy> all;
  all.reserve(2);
  append(all, 1.0);
  append(all, 2.0);

  std::cout << "total\n";
  const double sum = total(all);
  std::cout << one->value() << " and " << sum << '\n';
  return 0;
}
