# SPDX-License-Identifier: BSD-3-Clause
# Writes the case files FILES as string literals of a C++ source, OUTPUT.
set(entries "")
foreach(file ${FILES})
    get_filename_component(name ${file} NAME_WE)
    file(READ ${file} text)
    string(APPEND entries "    {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"coronet/cases/builtin.hpp\"

namespace coronet {

namespace {
constexpr BuiltinCase cases[] = {
${entries}};
}

std::span<BuiltinCase const> builtin_cases() { return cases; }

}  // namespace coronet
")
