"""The C++ files of a new package."""

from __future__ import annotations

import re

from ros2cli.verbs.pkg.plan import Plan

_NODE = """\
#include <cstdio>

int main(int argc, char ** argv)
{{
  (void) argc;
  (void) argv;

  printf("hello world {name} package\\n");
  return 0;
}}
"""

_NODE_WITH_LIBRARY = """\
#include "{name}/{library}.hpp"

int main(int argc, char ** argv)
{{
  (void) argc;
  (void) argv;

  {space}::{klass} from_the_library;
  (void) from_the_library;

  return 0;
}}
"""

_HEADER = """\
#ifndef {guard}
#define {guard}

#include "{name}/visibility_control.h"

namespace {space}
{{

class {klass}
{{
public:
  {klass}();

  virtual ~{klass}();
}};

}}  // namespace {space}

#endif  // {guard}
"""

_SOURCE = """\
#include "{name}/{library}.hpp"

namespace {space}
{{

{klass}::{klass}()
{{
}}

{klass}::~{klass}()
{{
}}

}}  // namespace {space}
"""

_VISIBILITY = """\
#ifndef {guard}
#define {guard}

// Which names of the library others can see: {upper}_PUBLIC in front of a class or function shows
// it. On Linux every name is shown unless it is told otherwise, on Windows it is the other way round.
#if defined _WIN32 || defined __CYGWIN__
  #define {upper}_EXPORT __declspec(dllexport)
  #define {upper}_IMPORT __declspec(dllimport)
  #ifdef {upper}_BUILDING_LIBRARY
    #define {upper}_PUBLIC {upper}_EXPORT
  #else
    #define {upper}_PUBLIC {upper}_IMPORT
  #endif
  #define {upper}_LOCAL
#else
  #define {upper}_EXPORT __attribute__ ((visibility("default")))
  #define {upper}_IMPORT
  #define {upper}_PUBLIC __attribute__ ((visibility("default")))
  #define {upper}_LOCAL __attribute__ ((visibility("hidden")))
#endif

#endif  // {guard}
"""


def node(plan: Plan) -> str:
    """Return the source file of the node."""
    return _filled(_NODE_WITH_LIBRARY if plan.library else _NODE, plan, "")


def library_header(plan: Plan) -> str:
    """Return the header of the library."""
    return _filled(_HEADER, plan, f"{plan.library}_HPP_")


def library_source(plan: Plan) -> str:
    """Return the source file of the library."""
    return _filled(_SOURCE, plan, "")


def visibility_control(plan: Plan) -> str:
    """Return the header with the macros that show and hide names."""
    return _filled(_VISIBILITY, plan, "VISIBILITY_CONTROL_H_")


def _filled(template: str, plan: Plan, guard: str) -> str:
    upper = _identifier(plan.name).upper()
    return template.format(
        name=plan.name,
        library=plan.library,
        space=_identifier(plan.name),
        klass="".join(part.capitalize() for part in _identifier(plan.library).split("_")),
        upper=upper,
        guard=f"{upper}__{_identifier(guard).upper()}",
    )


def _identifier(name: str) -> str:
    return re.sub(r"\W", "_", name)
