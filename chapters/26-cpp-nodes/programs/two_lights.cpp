#include <iostream>

class WarningLight
{
public:
  void switch_light()
  {
    light_is_on_ = !light_is_on_;
    std::cout << light_is_on_ << std::endl;
  }

private:
  bool light_is_on_ = false;
};

int main()
{
  WarningLight left;
  WarningLight right = left;
  left.switch_light();
  right.switch_light();
  return 0;
}
