// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/error.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>

namespace bspline_curve::io_tests {

/// A directory of its own for each test.
class FileTest : public testing::Test {
protected:
    FileTest() {
        const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
        directory_ = std::filesystem::temp_directory_path() /
                     (std::string("bspline curve ") + info->test_suite_name() + "." + info->name() +
                      " " + std::to_string(::getpid()));
        std::filesystem::create_directories(directory_);
    }

    ~FileTest() override { std::filesystem::remove_all(directory_); }

    [[nodiscard]] std::filesystem::path path(const std::string& name) const {
        return directory_ / name;
    }

    std::filesystem::path write(const std::string& name, std::string_view bytes) const {
        std::ofstream stream(path(name), std::ios::binary);
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return path(name);
    }

    [[nodiscard]] static std::string read(const std::filesystem::path& file) {
        std::ifstream stream(file, std::ios::binary);
        std::ostringstream bytes;
        bytes << stream.rdbuf();
        return bytes.str();
    }

    [[nodiscard]] std::size_t fileCount() const {
        return static_cast<std::size_t>(std::distance(
            std::filesystem::directory_iterator(directory_), std::filesystem::directory_iterator()
        ));
    }

private:
    std::filesystem::path directory_;
};

/// What an InputError says; fails the test where none is thrown or its code is another.
template <class Call>
std::string refusal(Call&& call, InputErrorCode code = InputErrorCode::UnreadableFile) {
    try {
        static_cast<void>(call());
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "nothing was refused";
    return {};
}

/// The bytes of a number, for binary files.
template <class Number>
std::string bytesOf(Number value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

inline void expectContains(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << '"' << text << "\" lacks \"" << part << '"';
}

}  // namespace bspline_curve::io_tests
