# SPDX-License-Identifier: Apache-2.0
# How everything of ours is compiled. Targets take it by linking dewbow_options privately.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Dev, Debug or Release" FORCE)
endif()

# -O3, not -O2: g++ 12 leaves most loops scalar at -O2. NDEBUG stays undefined: our checks are our
# own macros, and third-party asserts cost nothing that was measured.
set(CMAKE_CXX_FLAGS_RELEASE "-O3")
set(CMAKE_CXX_FLAGS_DEV "-O1 -g")

add_library(dewbow_options INTERFACE)
target_compile_options(dewbow_options INTERFACE
  -Wall -Wextra -Wshadow
  $<$<BOOL:${DEWBOW_WERROR}>:-Werror>
  # The same scene gives the same bits in every build of one compiler: no contraction to fused
  # multiply-add, no -ffast-math, no -march=native.
  -ffp-contract=off
  # These two change no result. They let sqrt and comparisons vectorise.
  -fno-math-errno -fno-trapping-math)
target_compile_definitions(dewbow_options INTERFACE
  DEWBOW_VERSION="${PROJECT_VERSION}"
  $<$<CONFIG:Dev,Debug>:_GLIBCXX_ASSERTIONS>)

if(DEWBOW_SANITIZE)
  add_compile_options(-fsanitize=${DEWBOW_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${DEWBOW_SANITIZE})
endif()
if(DEWBOW_COVERAGE)
  add_compile_options(--coverage -fprofile-update=atomic)
  add_link_options(--coverage)
endif()

if(PROJECT_IS_TOP_LEVEL)
  find_program(DEWBOW_CCACHE ccache)
  if(DEWBOW_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # The sloppiness is what ccache asks for before it caches with precompiled headers.
    set(CMAKE_CXX_COMPILER_LAUNCHER
        "${CMAKE_COMMAND};-E;env;CCACHE_SLOPPINESS=pch_defines,time_macros;${DEWBOW_CCACHE}")
    add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fpch-preprocess>)
  endif()
  find_program(DEWBOW_MOLD mold)
  if(DEWBOW_MOLD)
    add_link_options(-fuse-ld=mold)
  endif()
endif()
