"""Mutation of the graders: weakens one thing in a grader at a time, and sees whether a known mistake notices.

A grader's checks are functions of a recording. So every proof of an exercise (reference solution, other right
ways, mistakes) is run once, its recording kept, and each mutant only judges those recordings.

model.py       a mutant, what became of it, and all of it together; what travels to the process that judges
source.py      a grader module's text: which functions judge, and what in them only makes texts for learners
operators.py   the ways to weaken a function; bounds.py: those that are about numbers
mutants.py     all mutants of an exercise, and what a survivor asks for
recordings.py  the recordings of its proofs: kept, or made now, and what they depend on
judging.py     judges the recordings by one mutant; worker.py: the process that does so
run.py         `mutate`, and the parent's side of that process
command.py     `validate --mutate`; report.py: what it shows
"""
