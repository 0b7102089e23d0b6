# Writes HEADER with the commit of SOURCE as `git describe` names it; leaves it alone when it says so already.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define NETPOCKET_COMMIT \"${commit}\"\n")
