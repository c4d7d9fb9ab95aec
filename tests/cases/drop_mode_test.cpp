// SPDX-License-Identifier: BSD-3-Clause
#include "coronet/cases/drop_mode.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace coronet {

namespace {

TEST(DropMode, IsTheReference) {
    std::ifstream file(CORONET_SOURCE "/cases/reference/drop_oscillation_modes.csv");
    int rows = 0;
    for (std::string line, cell; std::getline(file, line);) {
        if (line.empty() || !std::isdigit(static_cast<unsigned char>(line[0]))) continue;
        std::vector<double> row;  // dim, n, Oh, omega0, omega, gamma, ...
        std::istringstream cells(line);
        while (std::getline(cells, cell, ',')) row.push_back(std::stod(cell));
        auto const mode = drop_mode(static_cast<int>(row[0]), static_cast<int>(row[1]), 1, 1, 1, row[2]);
        ++rows;
        ASSERT_EQ(mode.has_value(), row[4] > 0) << line;
        if (!mode) continue;
        EXPECT_NEAR(mode->angular_frequency, row[4], 0.6e-6) << line;  // printed to 1e-6
        EXPECT_NEAR(mode->damping, row[5], 0.6e-6) << line;
    }
    EXPECT_GT(rows, 80);
}

TEST(DropMode, OfLittleViscosityIsLambs) {
    for (int const n : {2, 3, 4, 10}) {
        double const R = 3e-3, rho = 900, sigma = 0.03;
        double const w = std::sqrt(n * (n * n - 1) * sigma / (rho * R * R * R));
        EXPECT_DOUBLE_EQ(drop_mode(2, n, R, rho, sigma, 0)->angular_frequency, w);
        EXPECT_EQ(drop_mode(2, n, R, rho, sigma, 0)->damping, 0);
        // The boundary layer takes a share of the order of the root of the Ohnesorge number.
        for (double const Oh : {1e-5, 1e-4, 1e-3}) {
            double const mu = Oh * std::sqrt(rho * sigma * R);
            auto const mode = drop_mode(2, n, R, rho, sigma, mu);
            EXPECT_NEAR(mode->angular_frequency / w, 1, n * n * Oh);
            EXPECT_NEAR(mode->damping / (2 * n * (n - 1) * mu / (rho * R * R)), 1, n * std::sqrt(Oh));
        }
    }
}

TEST(DropMode, OfAThickLiquidDoesNotOscillate) {
    EXPECT_TRUE(drop_mode(2, 2, 1, 1, 1, 0.84).has_value());  // critical at 0.8451
    EXPECT_FALSE(drop_mode(2, 2, 1, 1, 1, 0.85).has_value());
    EXPECT_TRUE(drop_mode(3, 2, 1, 1, 1, 0.76).has_value());  // critical at 0.7665
    EXPECT_FALSE(drop_mode(3, 2, 1, 1, 1, 0.77).has_value());
}

}  // namespace

}  // namespace coronet
