# SPDX-License-Identifier: Apache-2.0

# dewbow_module(NAME base [DEPENDS math …] [PRIVATE_LIBS TBB::tbb …] [HEADER_LIBS toml …])
#
# One static library dewbow_<name> (dewbow::<name>) from src/dewbow/<name>/**/*.cpp, and one test
# program <name>_test from the *_test.cpp beside them. DEPENDS are modules of ours and public;
# PRIVATE_LIBS are linked into the programs that use the module; HEADER_LIBS are third-party
# headers that no user of the installed library needs. A folder without sources gives a library of
# headers only, so that modules above it can be linked at any time.
function(dewbow_module)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME" "DEPENDS;PRIVATE_LIBS;HEADER_LIBS")
  set(target dewbow_${arg_NAME})
  set(folder "${PROJECT_SOURCE_DIR}/src/dewbow/${arg_NAME}")

  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${folder}/*.cpp")
  set(tests ${sources})
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")

  set(public PUBLIC)
  if(sources)
    add_library(${target} STATIC ${sources})
    foreach(library IN LISTS arg_HEADER_LIBS)
      target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:${library}>)
    endforeach()
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:dewbow_options> fmt::fmt
                                            ${arg_PRIVATE_LIBS})
  else()
    message(STATUS "src/dewbow/${arg_NAME} has no source yet: headers only")
    add_library(${target} INTERFACE)
    set(public INTERFACE)
  endif()
  add_library(dewbow::${arg_NAME} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${arg_NAME})
  target_compile_features(${target} ${public} cxx_std_20)
  target_include_directories(${target} ${public} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                                 $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  list(TRANSFORM arg_DEPENDS PREPEND dewbow_)
  target_link_libraries(${target} ${public} ${arg_DEPENDS})
  set_property(GLOBAL APPEND PROPERTY DEWBOW_MODULES ${arg_NAME})

  if(DEWBOW_BUILD_TESTS AND tests)
    dewbow_test(TARGET ${arg_NAME}_test PREFIX ${arg_NAME} LABEL unit SOURCES ${tests}
                LIBS ${target} fmt::fmt ${arg_PRIVATE_LIBS} ${arg_HEADER_LIBS})
  endif()
endfunction()

# dewbow_module_definitions(base NAME[=VALUE] …): seen by the module and by all that use it.
function(dewbow_module_definitions name)
  get_target_property(type dewbow_${name} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    target_compile_definitions(dewbow_${name} INTERFACE ${ARGN})
  else()
    target_compile_definitions(dewbow_${name} PUBLIC ${ARGN})
  endif()
endfunction()
