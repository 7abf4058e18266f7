// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/atomic_file.h"

#include "text/text_parsing.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <mutex>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace bspline_curve {

namespace {

namespace fs = std::filesystem;

/// The directory of a file that must not be empty.
fs::path directoryOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Where a link points to, so that the link stays.
fs::path behindLinks(const fs::path& file) {
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(file, error))) {
        return file;
    }
    const fs::path target = fs::weakly_canonical(file, error);
    return error ? file : target;
}

bool isDevice(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    return fs::exists(status) && fs::is_other(status);
}

void writeAll(int descriptor, const fs::path& file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written < 0) {
            refuseErrno(file);
        }
        bytes.remove_prefix(written);
    }
}

/// Owns an open file for the time of one write.
class Descriptor {
public:
    Descriptor(const fs::path& file, int flags)
        : value_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {}

    ~Descriptor() {
        if (value_ >= 0) {
            ::close(value_);
        }
    }

    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] int value() const { return value_; }

    /// Closes; false where the system reports only now that something was not written.
    bool close() { return ::close(std::exchange(value_, -1)) == 0; }

private:
    int value_;
};

void writeNew(const fs::path& file, const fs::path& named, std::string_view bytes) {
    Descriptor descriptor(file, O_WRONLY | O_CREAT | O_EXCL);
    if (descriptor.value() < 0) {
        refuseErrno(named);
    }
    writeAll(descriptor.value(), named, bytes);
    if (!descriptor.close()) {
        refuseErrno(named);
    }
}

fs::path temporaryBeside(const fs::path& file) {
    static std::atomic<unsigned> counter{0};
    std::string name = std::to_string(::getpid());
    name.append("-").append(std::to_string(counter++)).append(".tmp");
    // A dot in front hides it: ".curve.ply.1234-0.tmp".
    fs::path hidden = ".";
    hidden += file.filename();
    hidden += ".";
    hidden += name;
    return directoryOf(file) / hidden;
}

/// The temporary files that are there, for abandonAll(). Never destroyed, since the process may be
/// ending while a thread looks.
struct Temporaries {
    std::mutex mutex;
    std::set<fs::path> files;
};

Temporaries& temporaries() {
    static auto* const all = new Temporaries;
    return *all;
}

}  // namespace

void checkWritable(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::is_directory(status)) {
        refuseWriting(file, "is a directory, not a file");
    }
    // ENOENT: another process has deleted the file meanwhile.
    if (fs::exists(status) && ::access(file.c_str(), W_OK) != 0 && errno != ENOENT) {
        refuseErrno(file);
    }
    const fs::path directory = directoryOf(behindLinks(file));
    if (!fs::is_directory(directory, error)) {
        refuseWriting(file, "the directory " + directory.string() + " does not exist");
    }
    if (!isDevice(file) && ::access(directory.c_str(), W_OK | X_OK) != 0) {
        refuseErrno(file);
    }
}

AtomicFile::AtomicFile(const fs::path& file, std::string_view bytes) : file_(behindLinks(file)) {
    checkWritable(file_);
    if (isDevice(file_)) {
        deviceBytes_ = bytes;
        return;
    }
    temporary_ = temporaryBeside(file_);
    {
        const std::scoped_lock lock(temporaries().mutex);
        temporaries().files.insert(temporary_);
    }
    try {
        writeNew(temporary_, file_, bytes);
        std::error_code error;
        if (const fs::file_status old = fs::status(file_, error); fs::exists(old)) {
            fs::permissions(temporary_, old.permissions(), error);
        }
    } catch (...) {
        removeTemporary();
        throw;
    }
}

AtomicFile::~AtomicFile() {
    removeTemporary();
}

void AtomicFile::removeTemporary() {
    if (!temporary_.empty()) {
        const std::scoped_lock lock(temporaries().mutex);
        std::error_code error;
        fs::remove(temporary_, error);
        temporaries().files.erase(temporary_);
        temporary_.clear();
    }
}

void AtomicFile::commit() {
    if (temporary_.empty()) {
        const Descriptor device(file_, O_WRONLY);
        if (device.value() < 0) {
            refuseErrno(file_);
        }
        writeAll(device.value(), file_, deviceBytes_);
        return;
    }
    std::error_code error;
    {
        const std::scoped_lock lock(temporaries().mutex);
        fs::rename(temporary_, file_, error);
        if (!error) {
            temporaries().files.erase(temporary_);
        }
    }
    if (error) {
        refuseWriting(file_, "cannot be written: " + error.message());
    }
    temporary_.clear();
}

void AtomicFile::abandonAll() {
    temporaries().mutex.lock();
    for (const fs::path& file : temporaries().files) {
        std::error_code error;
        fs::remove(file, error);
    }
}

}  // namespace bspline_curve
