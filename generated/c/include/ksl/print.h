/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Printing to streams of the Kinematics Subroutine Library: not part of this library.
   Reason: the headers compute, and run without an operating system and its streams.
   Names:
   ksl_SE3_debug, ksl_SE3_print, ksl_SE3_printWithOptions, ksl_SE3f_debug, ksl_SE3f_print,
   ksl_SE3f_printWithOptions, ksl_mat3x3_debug, ksl_mat3x3_print, ksl_mat3x3_printWithOptions,
   ksl_mat3x3f_debug, ksl_mat3x3f_print, ksl_mat3x3f_printWithOptions, ksl_mat4x4_debug,
   ksl_mat4x4_print, ksl_mat4x4_printWithOptions, ksl_mat4x4f_debug, ksl_mat4x4f_print,
   ksl_mat4x4f_printWithOptions, ksl_vec3_debug, ksl_vec3_print, ksl_vec3_printWithOptions,
   ksl_vec3f_debug, ksl_vec3f_print, ksl_vec3f_printWithOptions, ksl_vec4_debug, ksl_vec4_print,
   ksl_vec4_printWithOptions, ksl_vec4f_debug, ksl_vec4f_print, ksl_vec4f_printWithOptions,
   ksl_coscrew_debug, ksl_coscrew_print, ksl_coscrew_printWithOptions, ksl_coscrewf_debug,
   ksl_coscrewf_print, ksl_coscrewf_printWithOptions, ksl_quaternion_debug, ksl_quaternion_print,
   ksl_quaternion_printWithOptions, ksl_quaternionf_debug, ksl_quaternionf_print,
   ksl_quaternionf_printWithOptions, ksl_screw_debug, ksl_screw_print, ksl_screw_printWithOptions,
   ksl_screwf_debug, ksl_screwf_print, ksl_screwf_printWithOptions, ksl_inertia_debug,
   ksl_inertia_print, ksl_inertia_printWithOptions, ksl_eulerangles_debug, ksl_eulerangles_print,
   ksl_eulerangles_printWithOptions, ksl_euleranglesf_debug, ksl_euleranglesf_print,
   ksl_euleranglesf_printWithOptions, ksl_array_debug, ksl_array_print, ksl_array_printWithOptions,
   ksl_arrayi_debug, ksl_arrayi_print, ksl_arrayi_printWithOptions, ksl_array2D_debug,
   ksl_array2D_print, ksl_array2D_printWithOptions, ksl_triang_debug, ksl_triang_print,
   ksl_triang_printWithOptions, ksl_triangb_debug, ksl_triangb_print, ksl_triangb_printWithOptions,
   ksl_triangi_debug, ksl_triangi_print, ksl_triangi_printWithOptions, ksl_print_options,
   ksl_print_setDefaultOptions, ksl_print_setBoolean, ksl_print_setBooleanOption,
   ksl_print_setBreakBetweenLinesInMatrix, ksl_print_setBreakBetweenLinesInMatrixOption,
   ksl_print_setDelimiter, ksl_print_setDelimiterOption, ksl_print_setInnerBrackets,
   ksl_print_setInnerBracketsOption, ksl_print_setOuterBrackets, ksl_print_setOuterBracketsOption,
   ksl_print_setRealFormat, ksl_print_setRealFormatOption, ksl_print_setRowColumnMajorPrinting,
   ksl_print_setRowColumnMajorPrintingOption. */
#error "ksl/print.h is not here: print the members, as in printf(\"%g\", v.x)"
