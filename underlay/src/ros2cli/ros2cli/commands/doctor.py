"""`ros2 doctor`, alias `ros2 wtf`: checks what can be checked here, and a report of it."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace


def add_arguments(parser: ArgumentParser) -> None:
    group = parser.add_mutually_exclusive_group()
    group.add_argument("--report", "-r", action="store_true", help="Print all reports.")
    group.add_argument(
        "--report-failed", "-rf", action="store_true", help="Print reports of failed checks only."
    )
    text = "Include warnings as failed checks. Warnings are ignored by default."
    parser.add_argument("--include-warnings", "-iw", action="store_true", help=text)
    text = "Exclude package checks or report."
    parser.add_argument("--exclude-packages", "-ep", action="store_true", help=text)


def main(args: Namespace) -> int:
    from ros2cli.checkup import CHECKS, known_graph
    from ros2cli.reports import REPORTS, print_reports

    known = known_graph()
    if args.report:
        print_reports([name for name in REPORTS if name != "package" or not args.exclude_packages], known)
        return 0
    warnings = {name: check(known) for name, check in CHECKS.items()}
    for warning in (warning for found in warnings.values() for warning in found):
        print(f"UserWarning: {warning}", file=sys.stderr)
    failed = [name for name, found in warnings.items() if found and args.include_warnings]
    _print_verdict(failed, len(CHECKS))
    if args.report_failed:
        print_reports(failed, known)
    return 1 if failed else 0


def _print_verdict(failed: list[str], count: int) -> None:
    if failed:
        print(f"\n{len(failed)}/{count} check(s) failed\n\nFailed modules: {' '.join(failed)}\n")
    else:
        print(f"\nAll {count} checks passed\n")
