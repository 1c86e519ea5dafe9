#pragma once

#include <cstddef>
#include <string>
#include <vector>

// A link of a robot arm: it is mounted on its parent, and its children are
// mounted on it.
struct Link {
  std::string name;
  // TODO 1: which one owns the other? One of these is a shared_ptr, one a weak_ptr.
  Link* parent = nullptr;
  std::vector<Link*> children;
};

// TODO 2: replace each Link* with a std::shared_ptr<Link>.

// Makes a new link, mounted on nothing.
Link* make_link(const std::string& name);

// Mounts the child on the parent.
void mount(Link* child, Link* parent);

// Returns the link that this one is mounted on. Returns an empty pointer if there
// is none, or if it has been deleted.
Link* parent_of(Link* link);

// Returns the number of links from this one on: itself, its children, theirs ...
std::size_t links_from(Link* link);
