// SPDX-License-Identifier: BSD-3-Clause

// A table is read as it stands; what is wrong with one is said with file, line and what would be right.

#include "coronet/io/csv.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "coronet/core/error.hpp"

namespace coronet {

namespace {

namespace fs = std::filesystem;

class CsvFile : public testing::Test {
protected:
    Csv read(std::string const& text) {
        std::ofstream(folder / "t.csv") << text;
        return read_csv(folder / "t.csv");
    }
    /// What is said, without the folder.
    std::string complaint(std::string const& text) {
        try {
            read(text);
            return "";
        } catch (CaseError const& error) {
            return std::string(error.what()).substr(folder.string().size() + 1);
        }
    }
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    fs::path folder = fs::temp_directory_path() / ("coronet_csv_test." + std::to_string(getpid()));
};

TEST_F(CsvFile, IsReadWithItsNamesNumbersAndLines) {
    Csv const table = read("# of a rheometer\n\nshear_rate, stress\n0.1,1e-3\n\n 10 ,\t-2.5 # once\r\n");
    EXPECT_EQ(table.columns, (std::vector<std::string>{"shear_rate", "stress"}));
    EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{0.1, 1e-3}, {10, -2.5}}));
    EXPECT_EQ(table.lines, (std::vector<int>{4, 6}));
}

TEST_F(CsvFile, MayBeginWithAByteOrderMark) {
    EXPECT_EQ(read("\xef\xbb\xbf"
                   "a\n1\n")
                  .columns.at(0),
              "a");
}

TEST_F(CsvFile, ThatIsWrongIsToldWhereAndWhatWouldBeRight) {
    EXPECT_EQ(complaint("a,b\n1,2\n3\n"), "t.csv:3: 1 values, but the 2 columns a, b need one each");
    EXPECT_EQ(complaint("a,b\n1,2,\n"), "t.csv:2: 3 values, but the 2 columns a, b need one each");
    EXPECT_EQ(complaint("a,b\n1,\n"), "t.csv:2: b is '', but must be a finite number such as 1.5e-3");
    EXPECT_EQ(complaint("a\n1.5 Pa\n"), "t.csv:2: a is '1.5 Pa', but must be a finite number such as 1.5e-3");
    EXPECT_EQ(complaint("a\nnan\n"), "t.csv:2: a is 'nan', but must be a finite number such as 1.5e-3");
    EXPECT_EQ(complaint("a\n1e999\n"), "t.csv:2: a is '1e999', but must be a finite number such as 1.5e-3");
    EXPECT_EQ(complaint("a;b\n1,5;2\n"),
              "t.csv:1: the columns must be parted by commas, and numbers have a decimal point");
    EXPECT_EQ(complaint("1,2\n3,4\n"), "t.csv:1: '1' is no name of a column: the first row must name them all");
    EXPECT_EQ(complaint("a,\n3,4\n"), "t.csv:1: '' is no name of a column: the first row must name them all");
    EXPECT_EQ(complaint("a,a\n3,4\n"), "t.csv:1: there are two columns 'a': leave one");
    EXPECT_EQ(complaint("a,b\n# 1,2\n"), "t.csv: the table is empty: it needs a row of names and rows of numbers");
    EXPECT_EQ(complaint(""), "t.csv: the table is empty: it needs a row of names and rows of numbers");
}

TEST_F(CsvFile, ThatIsNotThereIsSaidSo) {
    EXPECT_THROW(read_csv(folder / "none.csv"), CaseError);
    EXPECT_THROW(read_csv(folder), CaseError);
}

}  // namespace

}  // namespace coronet
