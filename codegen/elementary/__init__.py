"""Elementary functions as Programs: the same bits on every machine, in every language.

A function is stated in a format (`formats.py`), since its degrees and splits depend on it.  The
coefficients are derived here, the approximations and the roundings proved."""
