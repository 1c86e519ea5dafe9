"""Where a launch description comes from."""

from __future__ import annotations

from typing import TYPE_CHECKING

from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext
    from launch.launch_description import LaunchDescription


class LaunchDescriptionSource:
    """A description, or a file that makes one (loaded once, when it is needed)."""

    def __init__(
        self,
        launch_description: LaunchDescription | None = None,
        location: object = "",
        method: str = "unspecified mechanism from a script",
    ) -> None:
        self.__description = launch_description
        self.__location = normalize_to_list_of_substitutions(location)
        self.__expanded: str | None = None
        self.__method = method

    @property
    def location(self) -> str:
        """The path, or how it will be found while that is not known."""
        if self.__expanded is not None:
            return self.__expanded
        return " + ".join(str(sub) for sub in self.__location)

    @property
    def method(self) -> str:
        return self.__method

    def get_launch_description(self, context: LaunchContext) -> LaunchDescription:
        if self.__expanded is None:
            self.__expanded = perform_substitutions(context, self.__location)
        if self.__description is None:
            self.__description = self._get_launch_description(self.__expanded)
        return self.__description

    def try_get_launch_description_without_context(self) -> LaunchDescription | None:
        """The description where it is known before anything runs: None if the path depends on the launch."""
        from launch.substitutions.text_substitution import TextSubstitution

        if self.__description is None and all(isinstance(sub, TextSubstitution) for sub in self.__location):
            self.__expanded = "".join(sub.text for sub in self.__location)  # type: ignore[attr-defined]
            self.__description = self._get_launch_description(self.__expanded)
        return self.__description

    def _get_launch_description(self, location: str) -> LaunchDescription:
        raise NotImplementedError("only sources of files load descriptions")
