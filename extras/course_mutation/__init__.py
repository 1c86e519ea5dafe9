"""Mutation of the graders: weakens one thing in a grader at a time. A known mistake should reveal it.

A grader's checks are functions of a recording. So every proof of an exercise (reference solution,
alternatives, mistakes) runs once and keeps its recording. Each mutant only judges those recordings.

model.py       a mutant, its fate, and a whole run; what is sent to the judging process
source.py      a grader module's text: which functions judge, and which parts only make texts for learners
operators.py   the ways to weaken a function; bounds.py: those for numbers
mutants.py     all mutants of an exercise, and what a survivor shows to be missing
recordings.py  the recordings of its proofs, kept or made now, and what they depend on
judging.py     judges the recordings by one mutant; worker.py: the process that does it
run.py         `mutate`, and the parent's side of that process
command.py     `validate --mutate`; report.py: its output
"""
