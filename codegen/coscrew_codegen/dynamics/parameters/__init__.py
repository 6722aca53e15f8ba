"""Parameters on which torques depend linearly: those of links and of effects, and the fewest
combinations of them that torques tell."""
