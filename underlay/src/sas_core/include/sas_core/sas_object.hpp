// What classes of this family derive from to have a name.

#pragma once

#include <string>
#include <utility>

namespace sas
{

class Object
{
public:
  Object() = delete;
  std::string get_class_name() const {return class_name_;}

protected:
  explicit Object(std::string class_name) : class_name_(std::move(class_name)) {}

  const std::string class_name_;
};

}  // namespace sas
