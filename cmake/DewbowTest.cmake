# SPDX-License-Identifier: Apache-2.0
find_package(GTest REQUIRED)
include(GoogleTest)

set(dewbow_shared_data_default "${PROJECT_SOURCE_DIR}/../shared/data")
if(DEFINED ENV{DEWBOW_SHARED_DATA})
  set(dewbow_shared_data_default "$ENV{DEWBOW_SHARED_DATA}")
endif()
set(DEWBOW_SHARED_DATA "${dewbow_shared_data_default}" CACHE PATH
    "Optional test data that is not in the repository; tests that want it skip where it is absent")

# Every test program reuses one precompiled <gtest/gtest.h>.
file(WRITE "${PROJECT_BINARY_DIR}/generated/test_pch.cpp.in" "// SPDX-License-Identifier: Apache-2.0\n")
configure_file("${PROJECT_BINARY_DIR}/generated/test_pch.cpp.in"
               "${PROJECT_BINARY_DIR}/generated/test_pch.cpp" COPYONLY)
add_executable(dewbow_test_pch "${PROJECT_BINARY_DIR}/generated/test_pch.cpp")
target_link_libraries(dewbow_test_pch PRIVATE dewbow_options GTest::gtest_main)
target_precompile_headers(dewbow_test_pch PRIVATE <gtest/gtest.h>)

# dewbow_test(TARGET base_test PREFIX base LABEL unit SOURCES … LIBS …)
#
# One gtest program. ctest knows each of its tests as PREFIX.Suite.Name, under LABEL. Tests of suites
# whose name begins with Long carry the label long as well, and ./test leaves them out.
function(dewbow_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;PREFIX;LABEL" "SOURCES;LIBS")
  add_executable(${arg_TARGET} ${arg_SOURCES})
  target_link_libraries(${arg_TARGET} PRIVATE dewbow_options ${arg_LIBS} GTest::gtest_main)
  target_precompile_headers(${arg_TARGET} REUSE_FROM dewbow_test_pch)
  target_compile_definitions(${arg_TARGET} PRIVATE DEWBOW_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                                   DEWBOW_SHARED_DATA="${DEWBOW_SHARED_DATA}")
  set(discovery TEST_PREFIX "${arg_PREFIX}." NO_PRETTY_TYPES NO_PRETTY_VALUES DISCOVERY_MODE PRE_TEST
                DISCOVERY_TIMEOUT 60)
  set(properties LABELS ${arg_LABEL} ENVIRONMENT "DEWBOW_SOURCE_DIR=${PROJECT_SOURCE_DIR}")
  gtest_discover_tests(${arg_TARGET} ${discovery} TEST_FILTER "-Long*"
                       TEST_LIST ${arg_TARGET}_short PROPERTIES ${properties} TIMEOUT 300)
  gtest_discover_tests(${arg_TARGET} ${discovery} TEST_FILTER "Long*"
                       TEST_LIST ${arg_TARGET}_long PROPERTIES ${properties} TIMEOUT 3600)
  # gtest_discover_tests loses the second of two labels, so ctest adds it when it reads the list.
  set(labels_file "${PROJECT_BINARY_DIR}/generated/${arg_TARGET}_labels.cmake")
  file(CONFIGURE OUTPUT "${labels_file}" @ONLY CONTENT [=[
foreach(test IN LISTS @arg_TARGET@_long)
  set_tests_properties("${test}" PROPERTIES LABELS "@arg_LABEL@;long")
endforeach()
]=])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${labels_file}")
endfunction()

# dewbow_test_kind(analytic): tests/analytic/**/*_test.cpp, linked with everything.
function(dewbow_test_kind kind)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/${kind}/*.cpp")
  if(NOT sources)
    return()
  endif()
  dewbow_test(TARGET ${kind} PREFIX ${kind} LABEL ${kind} SOURCES ${sources}
              LIBS dewbow_umbrella fmt::fmt nlohmann_json::nlohmann_json)
  if(TARGET dewbow)
    target_compile_definitions(${kind} PRIVATE DEWBOW_BINARY="$<TARGET_FILE:dewbow>")
    add_dependencies(${kind} dewbow)
  endif()
endfunction()
