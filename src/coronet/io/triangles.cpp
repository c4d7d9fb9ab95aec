// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/io/triangles.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "coronet/core/error.hpp"

namespace coronet {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian, and is read as it lies");

constexpr std::size_t stl_header = 80, stl_triangle = 50;

/// The words of a text, line by line.
class Lines {
public:
    Lines(std::string const& text, std::string file) : stream_(text), file_(std::move(file)) {}

    /// The words of the next line that has any; none at the end.
    std::vector<std::string> next() {
        for (std::string line; std::getline(stream_, line);) {
            ++number_;
            std::istringstream words(line.substr(0, line.find('#')));
            std::vector<std::string> list{std::istream_iterator<std::string>(words), {}};
            if (!list.empty()) return list;
        }
        return {};
    }
    std::size_t number() const { return number_; }

    [[noreturn]] void wrong(std::string const& what) const {
        throw CaseError(fmt::format("{}:{}: {}", file_, number_, what));
    }
    double value(std::string const& word) const {
        double value = 0;
        char const* const end = word.data() + word.size();
        char const* const begin = word.data() + (word.starts_with('+') ? 1 : 0);
        auto const [stop, error] = std::from_chars(begin, end, value);
        if (error != std::errc() || stop != end || !std::isfinite(value))
            wrong(fmt::format("'{}' must be a finite number such as 1.5e-3", word));
        return value;
    }
    Triangles::Corner corner(std::vector<std::string> const& words) const {
        if (words.size() < 4) wrong(fmt::format("'{}' must be followed by three numbers", words.front()));
        return {{value(words[1]), value(words[2]), value(words[3])}};
    }

private:
    std::istringstream stream_;
    std::string file_;
    std::size_t number_ = 0;
};

Triangles of_ascii_stl(std::string const& text, std::string const& file) {
    Triangles all;
    Lines lines(text, file);
    std::array<Triangles::Corner, 3> triangle;
    std::size_t corners = 0, place = 0;
    bool open = false, ended = false;
    for (auto words = lines.next(); !words.empty(); words = lines.next()) {
        if (words[0] == "facet") {
            if (open) lines.wrong("a facet begins, but the one before has not ended: it lacks 'endfacet'");
            open = true;
            corners = 0;
            place = lines.number();
        } else if (words[0] == "vertex") {
            if (!open) lines.wrong("a vertex stands outside of any facet");
            if (corners == 3) lines.wrong("a facet has a fourth vertex: STL knows triangles only");
            triangle[corners++] = lines.corner(words);
        } else if (words[0] == "endfacet") {
            if (!open || corners != 3)
                lines.wrong(fmt::format("a facet ends with {} vertices: it needs three", corners));
            open = false;
            all.corners.push_back(triangle);
            all.place.push_back(place);
        } else if (words[0] == "endsolid") {
            ended = true;
        } else if (words[0] != "solid" && words[0] != "outer" && words[0] != "endloop") {
            lines.wrong(fmt::format(
                "'{}' is no word of STL: solid, facet, outer, vertex, endloop, endfacet, endsolid are", words[0]));
        }
    }
    if (open || !ended) lines.wrong("the file ends before 'endsolid': it has been cut short");
    return all;
}

Triangles of_binary_stl(std::string const& bytes, std::string const& file) {
    std::uint32_t count = 0;
    if (bytes.size() >= stl_header + 4) std::memcpy(&count, bytes.data() + stl_header, 4);
    std::size_t const wanted = stl_header + 4 + stl_triangle * static_cast<std::size_t>(count);
    if (bytes.size() < stl_header + 4 || bytes.size() != wanted)
        throw CaseError(fmt::format(
            "{}: this is no STL: as a text it would begin with 'solid', and as binary STL of {} triangles it "
            "would have {} bytes, but it has {}",
            file, count, wanted, bytes.size()));
    Triangles all;
    all.in_lines = false;
    for (std::size_t k = 0; k < count; ++k) {
        std::array<float, 9> numbers;  // behind the normal
        std::memcpy(numbers.data(), bytes.data() + stl_header + 4 + k * stl_triangle + 12, sizeof numbers);
        std::array<Triangles::Corner, 3> triangle;
        for (std::size_t n = 0; n < 9; ++n) {
            if (!std::isfinite(numbers[n]))
                throw CaseError(fmt::format("{}: triangle {} has a corner that is no finite number", file, k + 1));
            triangle[n / 3][static_cast<int>(n % 3)] = static_cast<double>(numbers[n]);
        }
        all.corners.push_back(triangle);
        all.place.push_back(k + 1);
    }
    return all;
}

Triangles of_obj(std::string const& text, std::string const& file) {
    Triangles all;
    Lines lines(text, file);
    std::vector<Triangles::Corner> vertices;
    for (auto words = lines.next(); !words.empty(); words = lines.next()) {
        if (words[0] == "v") vertices.push_back(lines.corner(words));
        if (words[0] != "f") continue;
        std::vector<Triangles::Corner> face;
        for (std::size_t k = 1; k < words.size(); ++k) {  // vertex, vertex/texture, vertex//normal: counted from 1, or
            double const at = lines.value(words[k].substr(0, words[k].find('/')));  // below 0 from the last one
            double const from_first = at < 0 ? static_cast<double>(vertices.size()) + at : at - 1;
            if (at == 0 || from_first != std::floor(from_first) || from_first < 0 ||
                from_first >= static_cast<double>(vertices.size()))
                lines.wrong(
                    fmt::format("a face names vertex {}, but there are {} before it", words[k], vertices.size()));
            face.push_back(vertices[static_cast<std::size_t>(from_first)]);
        }
        if (face.size() < 3) lines.wrong(fmt::format("a face has {} corners: it needs three or more", face.size()));
        for (std::size_t k = 2; k < face.size(); ++k) {
            all.corners.push_back({face[0], face[k - 1], face[k]});
            all.place.push_back(lines.number());
        }
    }
    return all;
}

}  // namespace

Triangles read_triangles(std::filesystem::path const& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file))
        throw CaseError(fmt::format("{}: there is no such file that can be read", file.string()));
    std::string const bytes{std::istreambuf_iterator<char>(stream), {}};
    if (bytes.empty()) throw CaseError(fmt::format("{}: the file is empty", file.string()));

    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (ending != ".stl" && ending != ".obj")
        throw CaseError(fmt::format("{}: a mesh is read from .stl or .obj, not from '{}'", file.string(), ending));
    // Some binary files begin with 'solid', too, but no text has a zero byte.
    bool const is_text = bytes.starts_with("solid") && bytes.find('\0') == std::string::npos;
    Triangles const all = ending == ".obj" ? of_obj(bytes, file.string())
                          : is_text        ? of_ascii_stl(bytes, file.string())
                                           : of_binary_stl(bytes, file.string());
    if (all.size() == 0) throw CaseError(fmt::format("{}: the file holds no triangle", file.string()));
    return all;
}

}  // namespace coronet
