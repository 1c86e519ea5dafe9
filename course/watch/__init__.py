"""`watch`: checks the exercise at every save, in a terminal that shows what came of it.

`loop` brings the parts together. `session` decides what happens and knows no terminal, no processes and no
files. `saves` tells of saves, and `checks` runs one check at a time in a process of its own. `screen` and
`terminal` show it all.
"""
