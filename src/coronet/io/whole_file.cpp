// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/io/whole_file.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "coronet/core/error.hpp"

namespace coronet {

namespace fs = std::filesystem;

void write_whole(fs::path const& file, std::string const& content) {
    auto part = file;
    part += ".part";
    std::error_code reason;
    errno = 0;
    std::ofstream stream(part, std::ios::binary);
    stream << content;
    stream.close();
    if (!stream) reason.assign(errno ? errno : EIO, std::generic_category());
    else fs::rename(part, file, reason);
    if (!reason) return;

    std::error_code ignored;
    fs::remove(part, ignored);
    throw RunError("cannot write " + file.string() + ": " + reason.message());
}

}  // namespace coronet
