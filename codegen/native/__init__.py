"""Native code and other calls, timed beside each other."""
