#include "link.hpp"

#include <numeric>

std::size_t Link::count() const {
  const auto add = [](std::size_t sum, const auto& child) { return sum + child->count(); };
  return std::accumulate(carried_.begin(), carried_.end(), std::size_t{1}, add);
}

std::shared_ptr<Link> make_link(std::string name) {
  return std::shared_ptr<Link>(new Link(std::move(name)));
}

void mount(std::shared_ptr<Link> child, std::shared_ptr<Link> parent) {
  parent->carry(std::move(child));
}

std::shared_ptr<Link> parent_of(const std::shared_ptr<const Link>& link) {
  return link->carrier();
}

std::size_t links_from(std::shared_ptr<const Link> link) {
  return link->count();
}
