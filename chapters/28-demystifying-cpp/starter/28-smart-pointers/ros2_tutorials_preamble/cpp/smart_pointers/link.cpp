#include "link.hpp"

Link* make_link(const std::string& name) {
  Link* link = new Link;
  link->name = name;
  return link;
}

void mount(Link* child, Link* parent) {
  child->parent = parent;
  parent->children.push_back(child);
}

Link* parent_of(Link* link) {
  return link->parent;
}

std::size_t links_from(Link* link) {
  std::size_t count = 1;
  for (Link* child : link->children) {
    count += links_from(child);
  }
  return count;
}
