"""The inner layer: the submission's programs, as a user without rights, who sees only what they need.

plan.py       what a sandbox is made of; travels from the parent to the grading process
identity.py   a user id and control groups that nobody else has, for as long as a grading takes
view.py       which files are to be seen
inner.py      the command line of bubblewrap for both: programs of an arena, and builds
holder.py     keeps the namespaces of one arena
launcher.py   starts programs in them, from outside
once.py       one command in namespaces of its own: a build
sandbox.py    the grading process's side of both
limits.py     what one submission may use up; rlimits
watchdog.py   sees when it is too much
"""
