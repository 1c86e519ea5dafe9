#!/bin/bash
# A little program for the shell: two comments, and one command.
echo "Howdy! You have made me a program."
