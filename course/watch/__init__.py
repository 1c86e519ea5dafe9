"""`watch`: checks the exercise on every save, and shows the result in the terminal.

`loop` connects the parts. `session` decides what happens, and uses no terminal and no processes. `saves`
reports saves, and `checks` runs one check at a time in a separate process. `screen` and `terminal` show
everything.
"""
