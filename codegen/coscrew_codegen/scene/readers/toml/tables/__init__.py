"""Tables of scene files on loops of the model, and on ranges and accuracy of its functions."""
