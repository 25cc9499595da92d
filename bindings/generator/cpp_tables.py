"""Writes src/capi/api_tables.hpp: what the library itself tells about the table at run time."""


def write(table):
    out = ["#pragma once\n"
           "/// Generated from bindings/api.toml by bindings/generate.py; do not edit.\n\n"
           '#include <cstdint>\n\n#include "build_info.hpp"\n\n'
           "namespace rollcon::capi {\n\n"
           "// clang-format off\n"
           "struct Feature { const char* name; bool built; };\n\n"
           "constexpr Feature feature_table[] = {\n"]
    for name, built, _ in table.features:
        value = f"ROLLCON_BUILD_{built.upper()} != 0" if isinstance(built, str) else str(built).lower()
        out.append(f'    {{"{name}", {value}}},\n')
    out.append("};\n\nstruct StatusText { std::int32_t status; const char* text; };\n\n"
               "constexpr StatusText status_table[] = {\n")
    out += [f'    {{{number}, "{doc}"}},\n' for _, number, doc in table.enums[0].values]
    return "".join(out) + "};\n// clang-format on\n\n}  // namespace rollcon::capi\n"
