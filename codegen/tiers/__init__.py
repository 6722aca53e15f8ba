"""Accuracy tiers: one function each, from a kernel's plain program to the tier's.

plain       fixed order, every operation rounded once             the names without a suffix
fused       products fused into sums by fma                       C only
accurate    single: computed in double, rounded once; double: compensated, carried as hi + lo
certified   plain, and a bound of each component's error that always holds
"""
