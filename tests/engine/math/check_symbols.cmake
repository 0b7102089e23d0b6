# Fails when one of the LIBRARIES asks the C library for an elementary function, whose last bit depends on the processor
# (engine/math/elementary.h). Of a long double they have one variant only.
set(names sin cos sincos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp exp2 exp10 expm1 log log2 log10
          log1p pow cbrt hypot tgamma lgamma erf erfc)
set(found)
foreach(library ${LIBRARIES})
  execute_process(COMMAND ${NM} --undefined-only --format=posix ${library} OUTPUT_VARIABLE symbols RESULT_VARIABLE result
                  ERROR_QUIET)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${NM} cannot read ${library}")
  endif()
  foreach(name ${names})
    if("\n${symbols}" MATCHES "\n(__)?${name}f?(_finite)? U")
      get_filename_component(file ${library} NAME)
      list(APPEND found "${file}: ${name}")
    endif()
  endforeach()
endforeach()
if(found)
  list(JOIN found "\n  " text)
  message(FATAL_ERROR "elementary functions of the C library are used:\n  ${text}")
endif()
