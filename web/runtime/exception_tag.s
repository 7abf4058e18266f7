# SPDX-License-Identifier: GPL-3.0-or-later
# The tag that all C++ exceptions are thrown with: its one value points to what is thrown.
	.tagtype	__cpp_exception i32
	.globl	__cpp_exception
__cpp_exception:
