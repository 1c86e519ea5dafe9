cat > drive.py << END
import sys

print(sys.argv[1:])
END
python3 drive.py slowly --meters 5
