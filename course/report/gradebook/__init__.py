"""A graded class as files that others read: a gradebook, CI formats, a letter to each learner.

model      what is reported, as the batch knows it
cleaning   what may be told of it: the one place where texts are made harmless
sheets     the model cleaned, with points and totals: what every format below is made of
words      sentences about a check; markup: texts inside Markdown
spreadsheet, document, junit, gradescope, autograder, summary, annotations, classroom, letter
           one format each: pure functions from sheets to text
files      writes them

A format takes sheets and nothing else, so none can tell what cleaning has kept back. docs/results.md
describes each of them.
"""
