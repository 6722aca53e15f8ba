# Made by `coscrew generate`; changes are overwritten.
"""The C headers; coscrew.get_include() names their folder."""
