# How every room is built: one language standard, one set of warnings, one rule of floating point.

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

add_library(hallux_rules INTERFACE)
target_include_directories(hallux_rules INTERFACE "${PROJECT_SOURCE_DIR}")
# No contraction to fused multiply-add: the same input gives the same bits on every x86-64 machine.
target_compile_options(hallux_rules INTERFACE -Wall -Wextra -Wconversion -Wshadow -Werror -ffp-contract=off)
target_compile_definitions(hallux_rules INTERFACE GLM_FORCE_EXPLICIT_CTOR)
if(HALLUX_SANITIZER STREQUAL "address")
  target_compile_options(hallux_rules INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(hallux_rules INTERFACE -fsanitize=address,undefined)
elseif(HALLUX_SANITIZER STREQUAL "thread")
  target_compile_options(hallux_rules INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(hallux_rules INTERFACE -fsanitize=thread)
elseif(NOT HALLUX_SANITIZER STREQUAL "")
  message(FATAL_ERROR "HALLUX_SANITIZER is '${HALLUX_SANITIZER}'; it must be empty, address or thread")
endif()

option(HALLUX_GROUPS "Compile the sources of a target in groups; without, each alone, as the tools that read code want it" ON)
find_program(HALLUX_PYTHON python3)

# hallux_groups(TARGET): sources that share their headers are compiled as one (docs/decisions/0015). Groups are chosen when the
# folder is configured; a private name that comes to stand in two files of a group is an error until it is configured again,
# which ./run and ./test do where a source changed.
function(hallux_groups target)
  if(NOT HALLUX_GROUPS OR NOT HALLUX_PYTHON)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source NORMALIZE)
    set_property(GLOBAL APPEND_STRING PROPERTY hallux_grouped_sources "${target}\t${source}\n")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # g++ takes a source that another includes for a header, in which a type of one file alone would be a mistake.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# Chooses all groups at once, when every target is known: headers are read once.
function(hallux_choose_groups)
  get_property(asked GLOBAL PROPERTY hallux_grouped_sources)
  if(NOT asked)
    return()
  endif()
  file(WRITE "${PROJECT_BINARY_DIR}/grouped_sources.txt" "${asked}")
  execute_process(COMMAND "${HALLUX_PYTHON}" "${PROJECT_SOURCE_DIR}/cmake/group_sources.py" 1500
            "${PROJECT_BINARY_DIR}/grouped_sources.txt" "${PROJECT_BINARY_DIR}/chosen_groups.txt"
    COMMAND_ERROR_IS_FATAL ANY)
  file(STRINGS "${PROJECT_BINARY_DIR}/chosen_groups.txt" rows)
  foreach(row IN LISTS rows)
    string(REPLACE "\t" ";" row "${row}")
    list(GET row 0 target)
    list(GET row 1 source)
    list(GET row 2 number)
    set_source_files_properties("${source}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP "${target}_${number}")
  endforeach()
endfunction()
cmake_language(DEFER DIRECTORY "${CMAKE_SOURCE_DIR}" CALL hallux_choose_groups)

# hallux_headers(NAME USES library... HEADERS header...): a target whose precompiled headers others take. A file still names
# each header that it needs: clang-tidy reads it without these.
function(hallux_headers name)
  cmake_parse_arguments(HEADERS "" "" "USES;HEADERS" ${ARGN})
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "")
  add_library(${name} OBJECT "${source}")
  target_link_libraries(${name} PRIVATE hallux_rules ${HEADERS_USES})
  target_precompile_headers(${name} PRIVATE ${HEADERS_HEADERS})
endfunction()

# What more than half of all files read in the end.
set(hallux_common_headers <algorithm> <array> <cmath> <filesystem> <functional> <iomanip> <map> <memory> <optional>
    <span> <sstream> <string> <string_view> <vector> <glm/gtc/matrix_transform.hpp> <glm/gtc/quaternion.hpp>)
hallux_headers(hallux_common HEADERS ${hallux_common_headers})

# hallux_room(NAME SOURCES file... USES library...): a library whose headers are named from the repository root.
function(hallux_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;USES" ${ARGN})
  add_library(${name} STATIC ${ROOM_SOURCES})
  target_link_libraries(${name} PUBLIC hallux_rules ${ROOM_USES})
  # A section for each function: the linker leaves out what the program does not call, and tests/architecture lists it.
  target_compile_options(${name} PRIVATE -ffunction-sections -fdata-sections)
  target_precompile_headers(${name} REUSE_FROM hallux_common)
  hallux_groups(${name})
endfunction()

# hallux_suites(NAME LABEL TIMEOUT): each suite of a GoogleTest program becomes a CTest test when the program is built.
function(hallux_suites name label timeout)
  set(output "${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake")
  add_custom_command(TARGET ${name} POST_BUILD BYPRODUCTS "${output}" VERBATIM
    COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:${name}>" "-DOUTPUT=${output}"
            "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}" "-DLABEL=${label}" "-DTIMEOUT=${timeout}"
            -P "${PROJECT_SOURCE_DIR}/cmake/list_suites.cmake")
  set(when_built "${CMAKE_CURRENT_BINARY_DIR}/${name}_when_built.cmake")
  file(WRITE "${when_built}" "if(EXISTS \"${output}\")\n  include(\"${output}\")\n"
    "else()\n  add_test(${name}_NOT_BUILT ${name}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${when_built}")
endfunction()

find_program(HALLUX_LLD ld.lld)

# What ./test --all builds besides: long runs, tests of real bones, tools that draw or search for developers.
add_custom_target(hallux_all_tests)
function(hallux_only_for_all name)
  set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL TRUE)
  add_dependencies(hallux_all_tests ${name})
endfunction()

# hallux_test(NAME LABEL fast|slow|long|meshes [BY_SUITE] SOURCES file... USES library...): one GoogleTest program; of a fast one,
# or one whose suites share what takes long, each suite is a CTest test, else each case.
function(hallux_test name)
  cmake_parse_arguments(TEST "BY_SUITE" "LABEL;TIMEOUT" "SOURCES;USES" ${ARGN})
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 600)
  endif()
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE hallux_rules ${TEST_USES} GTest::gtest_main)
  target_precompile_headers(${name} REUSE_FROM hallux_test_common)
  hallux_groups(${name})
  # A hundred programs are linked for the tests; this linker takes a quarter of the time.
  if(HALLUX_LLD)
    target_link_options(${name} PRIVATE -fuse-ld=lld)
  endif()
  # Lines for a debugger are in the objects, and in the programs of a debug build; in a hundred programs they are five gigabytes.
  if(HALLUX_SANITIZER STREQUAL "")
    target_link_options(${name} PRIVATE $<$<CONFIG:RelWithDebInfo>:-Wl,--strip-debug>)
  endif()
  # What is tested is optimised as it is shipped; the test itself waits longer for the compiler than it runs.
  target_compile_options(${name} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O1>)
  if(NOT TEST_LABEL MATCHES "^(fast|slow)$")
    hallux_only_for_all(${name})
  endif()
  if(TEST_LABEL STREQUAL "fast" OR TEST_BY_SUITE)
    hallux_suites(${name} ${TEST_LABEL} ${TEST_TIMEOUT})
  else()
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
      PROPERTIES LABELS "${TEST_LABEL}" TIMEOUT ${TEST_TIMEOUT})
  endif()
endfunction()

# hallux_embed(TARGET NAMESPACE FUNCTION file...): compiles data files into a table {name, text}.
function(hallux_embed target namespace function)
  hallux_embed_by(embed.cmake ${ARGV})
endfunction()

# hallux_embed_bytes: the same for pictures and whatever is no text.
function(hallux_embed_bytes target namespace function)
  hallux_embed_by(embed_bytes.cmake ${ARGV})
endfunction()

function(hallux_embed_by script target namespace function)
  set(output "${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp")
  set(inputs ${ARGN})
  list(TRANSFORM inputs PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" OUTPUT_VARIABLE paths)
  string(JOIN "|" joined ${paths})
  add_custom_command(OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DFILES=${joined}" "-DOUTPUT=${output}" "-DNAMESPACE=${namespace}"
            "-DFUNCTION=${function}" -P "${PROJECT_SOURCE_DIR}/cmake/${script}"
    DEPENDS ${paths} "${PROJECT_SOURCE_DIR}/cmake/${script}" VERBATIM)
  target_sources(${target} PRIVATE "${output}")
  # What the assembler reads, the compiler's list of what a source depends on does not name.
  set_source_files_properties("${output}" PROPERTIES OBJECT_DEPENDS "${paths}")
endfunction()
