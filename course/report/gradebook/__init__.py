"""A graded class as files for others: a gradebook, CI formats, a letter to each learner.

cleaning     which texts may leave the grading machine; the only place that makes them harmless
sheets       the cleaned results with points and totals, from which every format below is made
check_words  sentences about a check
junit, gradescope, github, letter
             the formats: pure functions from sheets to text
class_files  results.csv and results.json, and all files of a class in one folder

A format gets only sheets, so none can reveal what cleaning has removed. docs/results.md describes all
formats.
"""
