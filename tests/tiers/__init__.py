"""The promises of each tier: proofs, bounds, hard cases, searches for counterexamples."""
