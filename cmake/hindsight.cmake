# SPDX-FileCopyrightText: 2026 The Hindsight authors
# SPDX-License-Identifier: BSD-2-Clause

# Compiler settings that every target shares.
add_library(hindsight_options INTERFACE)
target_compile_options(hindsight_options INTERFACE
  -Wall -Wextra -Werror -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wnon-virtual-dtor
  -Wold-style-cast -Woverloaded-virtual -Wcast-align -Wunused -Wnull-dereference -Wduplicated-cond
  -Wlogical-op
  # The same sums on every machine: no fused multiply-add, so that replays and goldens agree.
  -ffp-contract=off
  # Nobody reads errno after a square root; without it, loops with roots are not vectorised.
  -fno-math-errno)
target_include_directories(hindsight_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  target_compile_options(hindsight_options INTERFACE -O3)
endif()
if(HINDSIGHT_SANITIZE)
  # The checks that sanitizers insert mislead the two warnings; other builds have them.
  target_compile_options(hindsight_options INTERFACE
    -fsanitize=${HINDSIGHT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    -Wno-null-dereference -Wno-maybe-uninitialized)
  target_compile_definitions(hindsight_options INTERFACE HINDSIGHT_SANITIZED)
  target_link_options(hindsight_options INTERFACE -fsanitize=${HINDSIGHT_SANITIZE})
endif()

# hindsight_library(NAME LINKS...): one static library from all sources of the current folder.
function(hindsight_library name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "_main\\.cpp$")
  if(NOT sources)
    set(sources ${PROJECT_BINARY_DIR}/${name}_empty.cpp)
    file(WRITE ${sources} "")
  endif()
  add_library(${name} STATIC ${sources})
  target_link_libraries(${name} PUBLIC hindsight_options ${ARGN})
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
endfunction()

# hindsight_lcm_types(TARGET PACKAGE-DIR): C++ headers from the .lcm files of a folder, in build/lcm/.
function(hindsight_lcm_types target folder)
  find_program(LCM_GEN lcm-gen REQUIRED)
  file(GLOB definitions CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.lcm)
  if(NOT definitions)
    add_library(${target} INTERFACE)
    return()
  endif()
  set(stamp ${CMAKE_CURRENT_BINARY_DIR}/${target}.stamp)
  add_custom_command(OUTPUT ${stamp}
    COMMAND ${LCM_GEN} --cpp --cpp-std=c++11 --cpp-hpath ${PROJECT_BINARY_DIR}/lcm ${definitions}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${definitions} COMMENT "lcm-gen ${folder}" VERBATIM)
  add_custom_target(${target}_gen DEPENDS ${stamp})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_gen)
  target_include_directories(${target} SYSTEM INTERFACE ${PROJECT_BINARY_DIR}/lcm)
  target_link_libraries(${target} INTERFACE PkgConfig::LCM)
endfunction()

# hindsight_embed(HEADER VARIABLE FILES...): a header with the files' texts as an array of strings.
function(hindsight_embed header variable)
  set(content "#pragma once\n#include <array>\nnamespace hindsight::tools {\ninline constexpr std::array ${variable} = {\n")
  foreach(file ${ARGN})
    file(READ ${file} text)
    string(APPEND content "R\"~~~(${text})~~~\",\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endforeach()
  string(APPEND content "};\n}\n")
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${header} CONTENT "${content}" @ONLY)
endfunction()
