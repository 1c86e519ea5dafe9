#ifndef HARDWARE_HPP
#define HARDWARE_HPP

#include <list>
#include <memory>
#include <string>

class Part : public std::enable_shared_from_this<Part> {
public:
  explicit Part(std::string name_) : name(std::move(name_)) {}

  void carry(std::shared_ptr<Part> child) {
    child->carrier_ = weak_from_this();
    carried_.push_back(std::move(child));
  }

  std::shared_ptr<Part> carrier() const {
    return carrier_.expired() ? nullptr : std::shared_ptr<Part>(carrier_);
  }

  std::size_t count() const;

  std::string name;

private:
  std::list<std::shared_ptr<Part>> carried_;
  std::weak_ptr<Part> carrier_;
};

std::shared_ptr<Part> make_part(std::string name);
void mount(std::shared_ptr<Part> child, std::shared_ptr<Part> parent);
std::shared_ptr<Part> parent_of(const std::shared_ptr<const Part>& part);
std::size_t parts_from(std::shared_ptr<const Part> part);

#endif
