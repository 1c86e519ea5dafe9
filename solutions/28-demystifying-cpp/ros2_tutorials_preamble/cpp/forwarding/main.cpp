#include "traced_entry.hpp"
#include "trip_log.hpp"

#include <iostream>

int main() {
  std::cout << "make\n";
  const auto one = make<TracedEntry>(20.0);

  std::cout << "append\n";
  std::vector<TracedEntry> entries;
  entries.reserve(2);
  append(entries, 1.0);
  append(entries, 2.0);

  std::cout << "total\n";
  const double meters = total(entries);
  std::cout << one->value() << " and " << meters << '\n';
  return 0;
}
