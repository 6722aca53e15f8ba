"""The files of a sweep and their checksums."""
