#include "hardware.hpp"

#include <numeric>

std::size_t Part::count() const {
  const auto add = [](std::size_t sum, const auto& child) { return sum + child->count(); };
  return std::accumulate(carried_.begin(), carried_.end(), std::size_t{1}, add);
}

std::shared_ptr<Part> make_part(std::string name) {
  return std::shared_ptr<Part>(new Part(std::move(name)));
}

void mount(std::shared_ptr<Part> child, std::shared_ptr<Part> parent) {
  parent->carry(std::move(child));
}

std::shared_ptr<Part> parent_of(const std::shared_ptr<const Part>& part) {
  return part->carrier();
}

std::size_t parts_from(std::shared_ptr<const Part> part) {
  return part->count();
}
