# SPDX-License-Identifier: GPL-3.0-or-later
#
# cmake -D VERSION=… -D SOURCE=… -D OUTPUT=… -P describe.cmake
# Writes the header that says which state of the sources a program was built from: the version, and
# in a checkout what git calls the commit. An unchanged header is left alone.

set(version ${VERSION})
find_package(Git QUIET)
if(Git_FOUND AND EXISTS ${SOURCE}/.git) # not that of a folder around it
    execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} describe --tags --always --dirty
        OUTPUT_VARIABLE state OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(state)
        string(APPEND version " (${state})")
    endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define PIXELPLUMB_VERSION \"${version}\"\n")
