#pragma once

#include <map>
#include <string>
#include <vector>

namespace pluginlib::detail
{

struct Element
{
  std::string name;
  std::map<std::string, std::string> attributes;
  /// Without that of its children.
  std::string text;
  std::vector<Element> children;

  /// The first child with this name; nothing if there is none.
  const Element * child(const std::string & child_name) const;
};

/// The elements at the top of a file: at least one. XML allows just one, but files with several descriptions of
/// libraries are common. Throws InvalidXMLException with the file, the line and the reason.
std::vector<Element> read_xml(const std::string & file);

}  // namespace pluginlib::detail
