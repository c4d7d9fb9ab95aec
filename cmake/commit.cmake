# SPDX-License-Identifier: BSD-3-Clause
# Writes the commit of the checkout SOURCE into a C++ source, OUTPUT, which is touched only if the commit has changed.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty=+ --exclude=*
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
    set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#include \"coronet/version.hpp\"

namespace coronet {
std::string commit() { return \"${commit}\"; }
}
")
