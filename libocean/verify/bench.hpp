// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bench of a group: threads, the list of rows, and measures of samples.
#pragma once

#include <cmath>
#include <complex>
#include <concepts>
#include <span>
#include <vector>

#include "ocean/internal/verify.hpp"
#include "ocean/ocean.hpp"
#include "ocean/parameters.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean::verify {

/// Runs cases and collects their rows.
class Bench {
  public:
    explicit Bench(const Request& asked) : request(asked), pool(asked.threads) {}

    void add(Row row) {
        if (request.done) request.done(row);
        rows.push_back(std::move(row));
    }
    OceanOptions options() const { return {.threads = request.threads}; }

    const Request& request;
    ThreadPool pool;
    std::vector<Row> rows;
};

// The groups, a file each.
void verify_spectra(Bench& bench);
void verify_statistics(Bench& bench);
void verify_propagation(Bench& bench);
void verify_foam(Bench& bench);
void verify_terrain(Bench& bench);
void verify_coast(Bench& bench);
void verify_hulls(Bench& bench);
void verify_backends(Bench& bench);
void verify_sea(Bench& bench);

/// The mean of numbers that are drawn at random, and its standard error.
struct SampleMean {
    double count = 0.0, sum = 0.0, squares = 0.0;

    void add(double value) {
        count += 1.0;
        sum += value;
        squares += value * value;
    }
    double mean() const { return sum / count; }
    double error() const { return std::sqrt((squares / count - mean() * mean()) / (count - 1.0)); }
};

template <typename Values>
double mean_of(const Values& values) {
    double sum = 0.0;
    for (const auto value : values) sum += static_cast<double>(value);
    return sum / static_cast<double>(values.size());
}

template <typename Values>
double variance_of(const Values& values) {
    const double centre = mean_of(values);
    double sum = 0.0;
    for (const auto value : values) sum += std::pow(static_cast<double>(value) - centre, 2);
    return sum / static_cast<double>(values.size());
}

template <typename A, typename B>
double relative_error(const A& values, const B& exact) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += std::pow(static_cast<double>(values[i]) - static_cast<double>(exact[i]), 2);
    }
    return std::sqrt(sum / static_cast<double>(values.size()) / variance_of(exact));
}

/// Returns the slope of the line through points by least squares, each with its weight.
double slope_of(
    std::span<const Point> points,
    double (*weight)(const Point&) = [](const Point&) { return 1.0; });

/// Returns the number of a wave along an axis of `side` samples, from its place in FFT order.
int wave_index(std::integral auto place, int side) {
    const int index = static_cast<int>(place);
    return index < side / 2 ? index : index - side;
}

/// Returns the Fourier coefficients of a square map, of exp(i k x), in FFT order.
std::vector<std::complex<double>> coefficients(std::span<const float> map);

/// One JONSWAP wind sea of `wind` [m/s] over `fetch` [m] on a grid.
Parameters wind_sea(double wind, double fetch, int resolution, double patch_size);

}  // namespace ocean::verify
