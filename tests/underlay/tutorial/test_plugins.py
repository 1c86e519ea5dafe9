"""The official tutorial on plugins in C++: a package with a base class, and another one with plugins."""

from __future__ import annotations

from pathlib import Path

from tests.underlay.tutorial.learner import WORKSPACE, create
from tests.underlay.tutorial.room import Room

_CREATE = "--build-type ament_cmake --license Apache-2.0"
BASE = f"polygon_base {_CREATE} --dependencies pluginlib --node-name area_node"
PLUGINS = f"polygon_plugins {_CREATE} --dependencies polygon_base pluginlib --library-name polygon_plugins"

HEADER = """\
#pragma once

namespace polygon_base
{
struct RegularPolygon
{
  virtual ~RegularPolygon() = default;
  virtual void initialize(double side_length) = 0;
  virtual double area() = 0;
};
}
"""
LIBRARY = """\
#include <cmath>
#include <polygon_base/regular_polygon.hpp>
#include <pluginlib/class_list_macros.hpp>

namespace polygon_plugins
{
template<int corners>
struct Polygon : polygon_base::RegularPolygon
{
  double side = 0;
  void initialize(double side_length) override {side = side_length;}
  double area() override {return corners * side * side / 4 / std::tan(M_PI / corners);}
};
struct Triangle : Polygon<3> {};
struct Square : Polygon<4> {};
}

PLUGINLIB_EXPORT_CLASS(polygon_plugins::Square, polygon_base::RegularPolygon)
PLUGINLIB_EXPORT_CLASS(polygon_plugins::Triangle, polygon_base::RegularPolygon)
"""
DESCRIPTIONS = """\
<library path="polygon_plugins">
  <class type="polygon_plugins::Square" base_class_type="polygon_base::RegularPolygon">
    <description>Four sides</description>
  </class>
  <class type="polygon_plugins::Triangle" base_class_type="polygon_base::RegularPolygon">
    <description>Three sides</description>
  </class>
</library>
"""
NODE = """\
#include <pluginlib/class_loader.hpp>
#include <polygon_base/regular_polygon.hpp>

int main()
{
  using polygon_base::RegularPolygon;
  pluginlib::ClassLoader<RegularPolygon> loader("polygon_base", "polygon_base::RegularPolygon");
  for (const auto & name : loader.getDeclaredClasses()) {
    std::shared_ptr<RegularPolygon> polygon = loader.createSharedInstance(name);
    polygon->initialize(10.0);
    printf("%s: %.2f\\n", loader.getName(name).c_str(), polygon->area());
  }
  try {
    loader.createSharedInstance("polygon_plugins::Circle");
  } catch (pluginlib::PluginlibException & error) {
    printf("%s\\n", error.what());
  }
}
"""
INSTALL = "install(\n  DIRECTORY include/\n  DESTINATION include\n)\n"
EXPORT = "ament_export_include_directories(\n  include\n)\n"
FOUND = "find_package(pluginlib REQUIRED)\n"
DESCRIBED = "pluginlib_export_plugin_description_file(polygon_base plugins.xml)\n"


def test_plugins(at_home: Room) -> None:
    terminal = at_home.terminal()
    create(terminal, BASE, PLUGINS)
    source = at_home.home / WORKSPACE / "src"
    base, plugins = source / "polygon_base", source / "polygon_plugins"
    (base / "include/polygon_base/regular_polygon.hpp").write_text(HEADER)
    (base / "src/area_node.cpp").write_text(NODE)
    _replace(base / "CMakeLists.txt", "ament_package()\n", f"{INSTALL}{EXPORT}ament_package()\n")
    (plugins / "src/polygon_plugins.cpp").write_text(LIBRARY)
    _replace(plugins / "CMakeLists.txt", FOUND, FOUND + DESCRIBED)

    build = "colcon build --packages-select polygon_base polygon_plugins"
    failed = terminal.run(build, code=1, patience=300.0)
    assert "Missing:" in failed and "/polygon_plugins/plugins.xml\n" in failed
    (plugins / "plugins.xml").write_text(DESCRIPTIONS)
    assert "Summary: 2 packages finished" in terminal.run(build, patience=300.0)
    terminal.run("source install/setup.bash")
    said = terminal.run("ros2 run polygon_base area_node").lines
    assert said[:2] == ["Square: 100.00", "Triangle: 43.30"]
    assert said[2].startswith("No package describes a class polygon_plugins::Circle with the base class ")


def _replace(file: Path, old: str, new: str) -> None:
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))
