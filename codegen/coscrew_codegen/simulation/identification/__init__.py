"""Identification of arms: base parameters and friction from measured torques, physical arms that
have them, and motions that excite them."""
