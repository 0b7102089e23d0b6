# Counts the instructions per element and step of a fixed run under callgrind, without and with AVX2, and compares with
# the record; fails when they grow by over a tenth. Unlike times these numbers are the same on a busy machine. With
# NETPOCKET_RENEW=1 in the environment the record is written instead. Arguments: VALGRIND, PROGRAM, RECORD.
set(limit_percent 110)

# Instructions per hundred elements and steps, as an integer: CMake's arithmetic knows no others.
function(count isa result)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env NETPOCKET_ISA=${isa} ${VALGRIND} --tool=callgrind --callgrind-out-file=/dev/null
            --collect-atstart=no "--toggle-collect=netpocket::Simulation::advance*" ${PROGRAM}
    OUTPUT_VARIABLE work ERROR_VARIABLE log RESULT_VARIABLE status)
  string(REGEX MATCH "Collected : ([0-9]+)" found "${log}")
  if(NOT status EQUAL 0 OR NOT found)
    message(FATAL_ERROR "callgrind failed: ${log}")
  endif()
  string(STRIP "${work}" work)
  math(EXPR per_hundred "100 * ${CMAKE_MATCH_1} / ${work}")
  set(${result} ${per_hundred} PARENT_SCOPE)
endfunction()

set(fresh "# Instructions per hundred elements and steps; renew: NETPOCKET_RENEW=1 ctest -R InstructionCount\n")
set(faults "")
foreach(isa baseline avx2)
  count(${isa} now)
  string(APPEND fresh "${isa} ${now}\n")
  set(before "none")
  if(EXISTS ${RECORD})
    file(STRINGS ${RECORD} line REGEX "^${isa} [0-9]+$")
    string(REGEX REPLACE "^${isa} " "" before "${line}")
  endif()
  message("${isa}: ${now} instructions per hundred elements and steps, recorded ${before}")
  if(NOT before MATCHES "^[0-9]+$")
    string(APPEND faults "${RECORD} has no record for ${isa}\n")
  else()
    math(EXPR bound "${before} * ${limit_percent} / 100")
    if(now GREATER bound)
      string(APPEND faults "${isa}: ${now} is more than a tenth above the record, ${before}\n")
    endif()
  endif()
endforeach()

if("$ENV{NETPOCKET_RENEW}" STREQUAL "1")
  file(WRITE ${RECORD} "${fresh}")
elseif(faults)
  message(FATAL_ERROR "${faults}")
endif()
