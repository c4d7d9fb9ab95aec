# SPDX-License-Identifier: BSD-3-Clause
# Writes the case files FILES and the tables TABLES as string literals of a C++ source, OUTPUT.
foreach(kind FILES TABLES)
    set(${kind}_entries "")
    foreach(file ${${kind}})
        get_filename_component(name ${file} NAME_WE)
        file(READ ${file} text)
        string(APPEND ${kind}_entries "    {\"${name}\", R\"text(${text})text\"},\n")
    endforeach()
endforeach()
file(WRITE ${OUTPUT} "#include \"coronet/cases/builtin.hpp\"

namespace coronet {

namespace {
constexpr BuiltinFile cases[] = {
${FILES_entries}};
constexpr BuiltinFile tables[] = {
${TABLES_entries}};
}

std::span<BuiltinFile const> builtin_cases() { return cases; }
std::span<BuiltinFile const> builtin_tables() { return tables; }

}  // namespace coronet
")
