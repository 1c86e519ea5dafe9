#include <iostream>
#include <memory>

struct Door
{
  ~Door() { std::cout << "deleted" << std::endl; }
};

int main()
{
  auto first = std::make_shared<Door>();
  auto second = first;
  std::weak_ptr<Door> note = first;

  first = nullptr;
  std::cout << "one" << std::endl;
  second = nullptr;
  std::cout << "two" << std::endl;
  return 0;
}
