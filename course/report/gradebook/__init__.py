"""A graded class as files that others read: a gradebook, CI formats, a letter to each learner.

cleaning     what may be told of it: the one place where texts are made harmless
sheets       the model cleaned, with points and totals: what every format below is made of
check_words  sentences about a check
junit, gradescope, github, letter
             the formats: pure functions from sheets to text
class_files  results.csv and results.json, and all files of a class in one folder

A format takes sheets and nothing else, so none can tell what cleaning has kept back. docs/results.md
describes each of them.
"""
