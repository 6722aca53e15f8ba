/* Made by `coscrew generate`; changes are overwritten. */
/* Printing to streams of the Kinematics Subroutine Library: not here. */
#error "ksl/print.h is not here: print the members, as in printf(\"%g\", v.x)"
