# Installs what other programs use into a folder, builds the example against it and runs it.
# -DBUILD=, -DSOURCE=, -DFOLDER=, -DCONFIG=, -DLAUNCHER=
function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
run("installing" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/prefix --component development)
run("configuring the example" ${CMAKE_COMMAND} -S ${SOURCE}/example -B ${FOLDER}/build -G Ninja
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=${FOLDER}/prefix -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
run("building the example" ${CMAKE_COMMAND} --build ${FOLDER}/build)
run("the pendulum" ${FOLDER}/build/pendulum)
if(NOT output STREQUAL "period 2.84 s\n")
  message(FATAL_ERROR "the pendulum swings with a ${output}")
endif()
run("the pocket" ${FOLDER}/build/all_of_it)
if(NOT output MATCHES "^[0-9]+ elements, finished\n$")
  message(FATAL_ERROR "the pocket says ${output}")
endif()
file(REMOVE_RECURSE ${FOLDER})
