// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/choices.hpp"

#include <stdexcept>

#include "coronet/cases/case.hpp"

namespace coronet {

namespace {

/// Looks at one key that is a choice, and passes by all others.
class ChoiceFinder final : public Keys {
public:
    explicit ChoiceFinder(std::string path) : path_(std::move(path)) {}
    Words words;

    void number(Key const&, double&) override {}
    void integer(Key const&, int&) override {}
    void text(Key const&, std::string&) override {}
    void choice(Key const& key, std::string&, Words const& allowed) override {
        if (key.path == path_) words = allowed;
    }
    void flag(Key const&, bool&) override {}
    void number_or(Key const&, double&, std::string const&) override {}
    void numbers(Key const&, std::vector<double>&, int) override {}
    void formula(Key const&, std::string&) override {}
    void formulas(Key const&, std::vector<std::string>&, int) override {}
    void named_numbers(Key const&, std::map<std::string, double>&) override {}
    void tables(Key const&, std::size_t, std::function<void(std::size_t)> const&,
                std::function<void(std::size_t, std::string const&)> const&) override {}

private:
    std::string path_;
};

}  // namespace

Keys::Words choices_of(std::string const& path) {
    ChoiceFinder finder(path);
    Case c;
    describe(finder, c);
    if (finder.words.empty()) throw std::logic_error("no key " + path + " allows a choice of words");
    return finder.words;
}

}  // namespace coronet
