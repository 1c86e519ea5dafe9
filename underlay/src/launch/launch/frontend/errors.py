"""What a launch file in XML or YAML can have wrong."""

from launch.invalid_launch_file_error import InvalidLaunchFileError


class InvalidFrontendLaunchFileError(InvalidLaunchFileError):
    """It is neither."""
