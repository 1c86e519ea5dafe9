echo 'print(__name__)' > wheels.py
python3 wheels.py
python3 -c 'import wheels'
