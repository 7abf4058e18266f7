// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/temporary_folder.h"

#include "bspline_curve/error.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace bspline_curve::cli {

TemporaryFolder::TemporaryFolder() {
    std::error_code error;
    std::string pattern =
        (std::filesystem::temp_directory_path(error) / "bspline_curve-XXXXXX").string();
    if (error || ::mkdtemp(pattern.data()) == nullptr) {
        throw InputError(
            InputErrorCode::UnwritableFile,
            "no folder for temporary files can be made (TMPDIR says where): " +
                (error ? error.message() : std::generic_category().message(errno))
        );
    }
    path_ = std::filesystem::absolute(pattern);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
}

}  // namespace bspline_curve::cli
