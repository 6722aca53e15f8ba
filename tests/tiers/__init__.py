"""What each tier promises: proofs, bounds, hard cases, searches for what breaks them."""
