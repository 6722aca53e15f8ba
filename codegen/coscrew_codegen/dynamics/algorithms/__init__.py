"""Algorithms of rigid-body dynamics: kinematics, RNEA, ABA, CRBA."""
