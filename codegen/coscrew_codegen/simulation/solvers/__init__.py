"""Integration by solvers that choose their steps, and the events at which these end."""
