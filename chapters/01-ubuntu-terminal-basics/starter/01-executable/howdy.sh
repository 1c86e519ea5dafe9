#!/bin/bash
# A little program: a first line that names bash, a comment, and one command.
echo "Howdy! You have made me a program."
