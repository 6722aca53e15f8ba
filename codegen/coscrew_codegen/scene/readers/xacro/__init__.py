"""Files of xacro."""
