mkdir wheels
echo 'print("loading wheels")' > wheels/__init__.py
echo 'RADIUS = 0.1' > wheels/sizes.py
cat > drive.py << END
import wheels
from wheels.sizes import RADIUS

print(RADIUS)
print(wheels.RADIUS)
END
python3 drive.py
