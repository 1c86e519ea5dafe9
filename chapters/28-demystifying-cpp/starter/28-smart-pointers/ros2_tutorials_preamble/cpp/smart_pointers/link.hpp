#pragma once

#include <cstddef>
#include <string>
#include <vector>

// A link of a robot arm: it is mounted on its parent, and its children are
// mounted on it.
struct Link {
  std::string name;
  // TODO 1: who owns whom? One of these two wants a shared_ptr, one a weak_ptr.
  Link* parent = nullptr;
  std::vector<Link*> children;
};

// TODO 2: a std::shared_ptr<Link> in the place of each Link*.

// A new link, mounted on nothing.
Link* make_link(const std::string& name);

// Mounts the child on the parent.
void mount(Link* child, Link* parent);

// What the link is mounted on; an empty pointer where there is no such link,
// or where it has been deleted.
Link* parent_of(Link* link);

// How many links there are from this one on: itself, its children, theirs ...
std::size_t links_from(Link* link);
