"""`grade`: a class of submissions in one command."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from course.batch.cluster import LOCAL
from course.cli.class_ import Asked, Graders, grade_class, look
from course.cli.options import options_of
from course.cli.words import examples, typed
from course.errors import ExitCode, MissingHere, UsageError

EXAMPLES = examples(
    ("grade class/", "all that is found"),
    ("grade class.zip --dry-run", "only show what is found"),
    ("grade class.csv --exercises 18,20-client", "some, of a roster"),
    ("grade class/ --cluster tcp://host:8786", "on Dask workers"),
)


def grade(
    ctx: typer.Context,
    submissions: Annotated[
        Path, typer.Argument(metavar="SUBMISSIONS", help="A folder, an archive or a CSV roster.")
    ],
    exercises: Annotated[
        str, typer.Option("--exercises", metavar="ID,...", help="Only these; else all whose files are found.")
    ] = "",
    jobs: Annotated[
        int | None, typer.Option("--jobs", min=1, max=64, help="Gradings at once; by default four a core.")
    ] = None,
    out: Annotated[Path, typer.Option("--out", metavar="DIR", help="Where results go.")] = Path("grades"),
    dry_run: Annotated[bool, typer.Option("--dry-run", help="Show what is found, and stop.")] = False,
    single: Annotated[bool, typer.Option("--single", help="SUBMISSIONS is one submission.")] = False,
    gradescope: Annotated[
        Path | None,
        typer.Option("--gradescope", metavar="FILE", help="With --single: Gradescope's results.json."),
    ] = None,
    no_sandbox: Annotated[
        bool, typer.Option("--no-sandbox", help="Run submissions even where they cannot be contained.")
    ] = False,
    cluster: Annotated[
        str | None,
        typer.Option("--cluster", metavar="ADDRESS", help="Grade on a Dask scheduler's workers; or `local`."),
    ] = None,
    cluster_security: Annotated[
        Path | None,
        typer.Option("--cluster-security", metavar="FILE", help="With --cluster: Dask's settings, for TLS."),
    ] = None,
) -> None:
    """Grade a class of submissions.

    Results are stored as they come. Killed or stopped at any moment, the same
    command goes on where it was. Submissions run contained: without network,
    without sight of this machine's files, with bounds on what they use up.
    """
    from course.cli.desk import course_of

    if gradescope and not single:
        raise UsageError("--gradescope is for one submission.", "Add --single.")
    if cluster:
        _look_at_cluster(cluster, cluster_security)
    elif cluster_security:
        raise UsageError("--cluster-security is for a cluster.", "Add --cluster.")
    if not (no_sandbox or dry_run) and cluster in (None, LOCAL):
        _look_at_machine()
    wanted = [name.strip() for name in exercises.split(",") if name.strip()]
    options = options_of(ctx)
    asked = Asked(submissions.absolute(), wanted, out.absolute(), single=single, course=options.course)
    course = course_of(options)
    if dry_run:
        look(course, asked)
        return
    graders = Graders(jobs, not no_sandbox, cluster, cluster_security)
    sound = grade_class(course, asked, graders, gradescope)
    raise typer.Exit(ExitCode.PASSED if sound else ExitCode.OUR_FAULT)


def _look_at_cluster(cluster: str, security: Path | None) -> None:
    from course.batch.cluster.connect import require_dask

    require_dask()
    if security and cluster == LOCAL:
        raise UsageError(f"--cluster {LOCAL} makes keys of its own.", "Leave --cluster-security out.")


def _look_at_machine() -> None:
    from course.arena.containment import sandbox_obstacle

    obstacle = sandbox_obstacle()
    if obstacle is not None:
        step = "--no-sandbox grades all the same: only for programs that you trust."
        raise MissingHere(
            f"Submissions cannot be contained on this machine: {obstacle}.",
            f"`{typed('doctor')}` tells how to get that. {step}",
        )
