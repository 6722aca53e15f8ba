"""Functions that steps of integrators call, and the steps."""
