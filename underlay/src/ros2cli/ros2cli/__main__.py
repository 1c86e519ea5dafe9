"""`python -m ros2cli`, for where no `ros2` script is installed."""

import sys

from ros2cli.main import main

sys.exit(main())
