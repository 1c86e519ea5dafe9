"""Mutation of the graders: weakens one thing in a grader at a time, and sees whether a known mistake notices.

A grader's checks are functions of a recording. So every proof of an exercise (reference solution, other right
ways, mistakes) is run once, its recording kept, and each mutant only judges those recordings.

model.py       a mutant, what became of it, and all of it together
source.py      a grader module's text: which functions judge an exercise
words.py       what in these functions only makes texts for the learner; it is left alone
operators.py   the ways to weaken a function; bounds.py: those that are about numbers
mutants.py     all mutants of an exercise
recordings.py  the recordings of its proofs: kept, or made now; keys.py: what they depend on
court.py       a process that judges the mutants of one exercise; bench.py: by which recordings
cases.py       what a court is told, and answers; trial.py: its parent's side
suggest.py     what a survivor asks for
run.py         `mutate`
"""
