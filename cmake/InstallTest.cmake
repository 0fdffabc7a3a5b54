# SPDX-License-Identifier: Apache-2.0
# Installs BUILD_DIR into a prefix of its own, then builds and runs EXAMPLE_DIR against it as a user
# would, and looks for EXPECT in what the program prints.

set(work "${BUILD_DIR}/install_test")
file(REMOVE_RECURSE "${work}")
execute_process(COMMAND ${CMAKE_COMMAND} --install "${BUILD_DIR}" --prefix "${work}/prefix"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S "${EXAMPLE_DIR}" -B "${work}/build"
                        "-DCMAKE_PREFIX_PATH=${work}/prefix" "-DCMAKE_CXX_COMPILER=${CXX}"
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build "${work}/build" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${work}/build/hello_prism" OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
message(STATUS "hello_prism printed:\n${said}")
if(NOT said MATCHES "${EXPECT}")
  message(FATAL_ERROR "expected '${EXPECT}' in it")
endif()
