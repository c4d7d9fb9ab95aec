// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/app/plot.hpp"

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "coronet/core/error.hpp"

namespace coronet {

namespace {

namespace fs = std::filesystem;

/// The package as installed beside the program (bin/ and share/), or in the source tree it was built from.
fs::path package() {
    auto const installed = fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "share/coronet/python";
    fs::path const folder = fs::exists(installed / "coronet_plot") ? installed : fs::path(CORONET_PYTHON_FOLDER);
    if (!fs::exists(folder / "coronet_plot"))
        throw RunError(fmt::format("the plotting package coronet_plot is neither in {} nor in {}", installed.string(),
                                   CORONET_PYTHON_FOLDER));
    return folder / "coronet_plot";
}

}  // namespace

int plot(std::string const& directory, std::vector<std::string> const& with) {
    char const* const chosen = std::getenv("CORONET_PYTHON");
    std::string const python = chosen ? chosen : "/usr/bin/python3";
    std::vector<std::string> words{python, "-B", package().string(), directory};
    if (!with.empty()) {
        words.push_back("--with");
        words.insert(words.end(), with.begin(), with.end());
    }
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    pid_t const child = fork();
    if (child == 0) {
        execvp(arguments[0], arguments.data());
        fmt::print(stderr, "{} cannot be started: set CORONET_PYTHON to a Python 3 with numpy, matplotlib and vtk\n",
                   python);
        _exit(3);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) < 0) throw RunError("the plotting program cannot be started");
    int const ended = WIFEXITED(status) ? WEXITSTATUS(status) : 3;
    return ended == 0 || ended == 2 ? ended : 3;
}

}  // namespace coronet
