"""The programs of turtlesim: a simulator that draws in the terminal, and three that drive turtles."""
