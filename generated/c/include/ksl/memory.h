/* Made by `coscrew generate`; changes are overwritten. */
/* Arrays of pointers of the Kinematics Subroutine Library: not here. */
#error "ksl/memory.h is not here: use calloc and free; for the system's memory.h include string.h"
