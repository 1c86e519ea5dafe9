#pragma once

#include <cstddef>
#include <string>
#include <vector>

// A link of a robot arm. It is mounted on its parent, and its children are mounted on it.
struct Link {
  std::string name;
  // TODO 1: decide who owns whom. One of these must be a shared_ptr, and the other a weak_ptr.
  Link* parent = nullptr;
  std::vector<Link*> children;
};

// TODO 2: replace each Link* with a std::shared_ptr<Link>.

// Creates a new link without a parent.
Link* make_link(const std::string& name);

// Mounts the child on the parent.
void mount(Link* child, Link* parent);

// Returns the link that this one is mounted on, or an empty pointer if there is none
// or if it has been deleted.
Link* parent_of(Link* link);

// Counts this link, its children, their children, and so on.
std::size_t links_from(Link* link);
