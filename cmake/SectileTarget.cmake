# Options for what is not the work itself: to compile it takes less time so. Under the sanitizers, a
# third of what compiling takes would go into optimising tests.
if(SECTILE_SANITIZE)
  set(SECTILE_OPTIMISE_A_LITTLE -O0)
else()
  set(SECTILE_OPTIMISE_A_LITTLE $<$<CONFIG:Release>:-O1>)
endif()

# sectile_target(NAME): the language standard, warnings and sanitizers that all targets share.
function(sectile_target name)
  target_compile_features(${name} PUBLIC cxx_std_20)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
  # Without contraction the same source gives the same bits on every machine.
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC 12 warns of string concatenation in its own header (GCC bug 105651).
    target_compile_options(${name} PRIVATE -Wno-restrict)
  endif()
  if(SECTILE_WARNINGS_AS_ERRORS)
    target_compile_options(${name} PRIVATE -Werror)
  endif()
  if(SECTILE_SANITIZE)
    # To look at each access for null and alignment takes a fifth of the time that compiling does;
    # AddressSanitizer sees the one, and the fuzz targets are compiled with both.
    target_compile_options(${name} PRIVATE -fsanitize=address,undefined
                           -fno-sanitize=null,alignment
                           -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${name} PRIVATE -fsanitize=address,undefined)
    target_compile_definitions(${name} PRIVATE SECTILE_SANITIZE)
  endif()
  if(SECTILE_SANITIZE_THREADS)
    target_compile_options(${name} PRIVATE -fsanitize=thread)
    target_link_options(${name} PRIVATE -fsanitize=thread)
    target_compile_definitions(${name} PRIVATE SECTILE_SANITIZE_THREADS)
  endif()
  if(SECTILE_FUZZ)
    target_compile_options(${name} PRIVATE -fsanitize=fuzzer-no-link,address,undefined
                           -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${name} PRIVATE -fsanitize=address,undefined)
  endif()
endfunction()

# sectile_one_source_per_folder(TARGET): compiles the sources of each folder as one, which takes half
# the time where all are built once. Names of one folder differ, so that this can be done.
function(sectile_one_source_per_folder name)
  get_target_property(sources ${name} SOURCES)
  foreach(source ${sources})
    cmake_path(GET source PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "${folder}" group)
    set_source_files_properties(${source} TARGET_DIRECTORY ${name} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# sectile_without_precompiled_headers(TARGET SOURCES...): GCC's <string> silences three warnings of
# its own by pragmas (-Wstringop-overflow, -Wstringop-overread, -Warray-bounds), and these are lost
# when it is precompiled. Sources in which such a warning then appears do without.
function(sectile_without_precompiled_headers name)
  set_source_files_properties(${ARGN} TARGET_DIRECTORY ${name}
                              PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()
