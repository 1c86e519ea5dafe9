#include "descriptions.hpp"

#include <filesystem>

#include "pluginlib/exceptions.hpp"
#include "rcutils/logging_macros.h"
#include "xml.hpp"

namespace pluginlib::detail
{

namespace
{

/// Of the nearest folder around the file that contains a package.xml; empty if there is none.
std::string package_of(const std::string & file)
{
  std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  while (!std::filesystem::exists(folder / "package.xml")) {
    if (!folder.has_relative_path()) {
      return "";
    }
    folder = folder.parent_path();
  }
  const auto package = read_xml(folder / "package.xml").front();
  const auto name = package.child("name");
  return name ? name->text : "";
}

std::vector<Element> libraries_of(const std::string & file)
{
  auto elements = read_xml(file);
  const auto first = elements.front();
  if (first.name == "class_libraries") {
    return first.children;
  }
  if (first.name != "library") {
    throw InvalidXMLException(
            file + ": the first element must be <library> or <class_libraries>, not <" + first.name + ">");
  }
  return elements;
}

std::string attribute(const Element & described, const std::string & name, const std::string & file)
{
  const auto found = described.attributes.find(name);
  if (found == described.attributes.end()) {
    throw ClassLoaderException(file + ": a <class> lacks the attribute '" + name + "'");
  }
  return found->second;
}

ClassDesc description(
  const Element & described, const std::string & library, const std::string & package,
  const std::string & file)
{
  const auto type = attribute(described, "type", file);
  const auto named = described.attributes.find("name");
  const auto text = described.child("description");
  return {
    named == described.attributes.end() ? type : named->second,
    type,
    attribute(described, "base_class_type", file),
    package,
    text ? text->text : "There is no <description> of this class.",
    library,
    file};
}

}  // namespace

std::vector<ClassDesc> read_descriptions(const std::string & file)
{
  std::vector<ClassDesc> found;
  const auto libraries = libraries_of(file);
  const auto package = package_of(file);
  if (package.empty()) {
    RCUTILS_LOG_ERROR_NAMED(
      "pluginlib.ClassLoader", "%s: there is no package.xml with a <name> in this folder or above, so the "
      "libraries will not be found", file.c_str());
  }
  for (const auto & library : libraries) {
    if (library.name != "library") {
      continue;
    }
    const auto path = library.attributes.find("path");
    if (path == library.attributes.end() || path->second.empty()) {
      RCUTILS_LOG_ERROR_NAMED(
        "pluginlib.ClassLoader", "%s: skipped a <library> without the attribute 'path'", file.c_str());
      continue;
    }
    for (const auto & described : library.children) {
      if (described.name == "class") {
        found.push_back(description(described, path->second, package, file));
      }
    }
  }
  return found;
}

}  // namespace pluginlib::detail
