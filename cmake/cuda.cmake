# SPDX-License-Identifier: BSD-3-Clause
# The CUDA backend: one .cu file per scheme. The architectures are named because `native` fails where there is no GPU.
set(CMAKE_CUDA_ARCHITECTURES 75 80 90)
enable_language(CUDA)
# CMake 3.25 knows no flag for C++20 with this compiler: it is given by hand.
set(CMAKE_CUDA_STANDARD_DEFAULT "")

file(GLOB_RECURSE cuda_sources CONFIGURE_DEPENDS src/coronet/*.cu)
add_library(coronet_cuda STATIC ${cuda_sources})
target_compile_options(coronet_cuda PRIVATE $<$<COMPILE_LANGUAGE:CUDA>:-std=c++20>)
target_link_libraries(coronet_cuda PUBLIC coronet_core)

add_executable(device_rates bench/device_rates.cpp)
target_link_libraries(device_rates PRIVATE coronet_cuda)
