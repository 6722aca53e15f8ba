"""What somebody adds to the generator, a file each; tests put them into a copy of it."""
