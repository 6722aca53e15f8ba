"""Operations as plain Programs: let-bound SymPy, simplified, in an order."""
