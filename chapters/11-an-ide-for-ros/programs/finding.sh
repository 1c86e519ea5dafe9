mkdir library
echo 'RADIUS = 0.1' > library/wheels.py
python3 -c 'import wheels; print(wheels.RADIUS)'
PYTHONPATH=library python3 -c 'import wheels; print(wheels.RADIUS)'
