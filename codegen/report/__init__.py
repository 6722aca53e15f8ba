"""`coscrew report`: what every kernel's error and time are on this machine, as measured."""
