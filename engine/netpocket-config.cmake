# find_package(netpocket): the engine's libraries, installed with their headers.
include(CMakeFindDependencyMacro)
find_dependency(Boost 1.74)
find_dependency(Eigen3)
find_dependency(fmt)
find_dependency(nlohmann_json)
find_dependency(Threads)
find_dependency(tomlplusplus)
include(${CMAKE_CURRENT_LIST_DIR}/netpocket-targets.cmake)
