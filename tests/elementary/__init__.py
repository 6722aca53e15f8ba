"""Elementary functions as Programs: their derivations, proofs, errors and special values."""
