"""Torques as linear functions of parameters."""
