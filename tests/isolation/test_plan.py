"""The limits that the kernel gets."""

from __future__ import annotations

import dataclasses
import resource
import subprocess
import sys

from course.isolation.isolation_plan import (
    IsolationPlan,
    ResourceLimits,
    for_sanitizers,
    most_processes,
    rlimits,
)
from course.model import codec


def test_each_limit_is_the_kernels_too() -> None:
    values = dict(rlimits(ResourceLimits(processes=80, file=5, files=6, cpu=7.5, address_space=8)))
    assert values[resource.RLIMIT_FSIZE] == 5
    assert values[resource.RLIMIT_NOFILE] == 6
    assert values[resource.RLIMIT_CPU] == 7
    assert values[resource.RLIMIT_AS] == 8
    assert values[resource.RLIMIT_CORE] == 0


def test_only_the_address_sanitizer_gets_more_addresses() -> None:
    wide = for_sanitizers(ResourceLimits(memory=7))
    assert wide.address_space > 20 * 1024**4 > ResourceLimits().address_space
    assert dataclasses.replace(wide, address_space=ResourceLimits().address_space) == ResourceLimits(memory=7)


def test_the_control_group_refuses_first() -> None:
    """It counts refusals; the other limit only refuses."""
    limits = ResourceLimits(processes=80)
    assert dict(rlimits(limits))[resource.RLIMIT_NPROC] == most_processes(limits) > limits.processes


def test_a_plan_travels() -> None:
    plan = IsolationPlan(12, ("/a", "/b"), ("/c",), ("/d",), ResourceLimits(memory=1, cpu=2.5))
    plan = dataclasses.replace(plan, linked=(("/c", "/e"),))
    assert codec.from_json(codec.to_json(plan), IsolationPlan, "the plan") == plan


def test_the_grading_process_is_bounded_itself() -> None:
    code = (
        "from course.isolation.isolation_plan import bound_ourselves\nbound_ourselves()\n"
        "try:\n    bytearray(3 * 1024**3)\nexcept MemoryError:\n    print('refused')\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.stdout == "refused\n", done.stderr
