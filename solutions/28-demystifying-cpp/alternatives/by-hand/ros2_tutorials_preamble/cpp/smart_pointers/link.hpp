#ifndef LINK_HPP
#define LINK_HPP

#include <list>
#include <memory>
#include <string>

class Link : public std::enable_shared_from_this<Link> {
public:
  explicit Link(std::string name_) : name(std::move(name_)) {}

  void carry(std::shared_ptr<Link> child) {
    child->carrier_ = weak_from_this();
    carried_.push_back(std::move(child));
  }

  std::shared_ptr<Link> carrier() const {
    return carrier_.expired() ? nullptr : std::shared_ptr<Link>(carrier_);
  }

  std::size_t count() const;

  std::string name;

private:
  std::list<std::shared_ptr<Link>> carried_;
  std::weak_ptr<Link> carrier_;
};

std::shared_ptr<Link> make_link(std::string name);
void mount(std::shared_ptr<Link> child, std::shared_ptr<Link> parent);
std::shared_ptr<Link> parent_of(const std::shared_ptr<const Link>& link);
std::size_t links_from(std::shared_ptr<const Link> link);

#endif
