// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/resultslock.h"

#include <QCryptographicHash>
#include <QtEndian>

#include <cerrno>

namespace pixelplumb {

namespace {

enum class Wait { No, Yes };

constexpr off_t placeOfRuns = 0; ///< the byte that runs share; those behind it are submissions

/// By a hash, since runs may see different submissions.
off_t placeOf(const QByteArray &submission)
{
    const QByteArray hash = QCryptographicHash::hash(submission, QCryptographicHash::Sha256);
    return placeOfRuns + 1 + off_t(qFromBigEndian<quint64>(hash.constData()) >> 2);
}

/// Sets the byte's lock to F_RDLCK, F_WRLCK or F_UNLCK; false where another run's lock forbids it.
/// The lock belongs to the descriptor (OFD), so that two runs in one process exclude each other.
bool setLock(const Descriptor &file, off_t place, int kind, Wait wait)
{
    struct flock lock = {};
    lock.l_type = short(kind);
    lock.l_whence = SEEK_SET;
    lock.l_start = place;
    lock.l_len = 1;
    const int command = wait == Wait::Yes ? F_OFD_SETLKW : F_OFD_SETLK;
    while (fcntl(file.number(), command, &lock) != 0) {
        if (errno != EINTR)
            return errno != EAGAIN && errno != EACCES;
    }
    return true;
}

} // namespace

Result<ResultsLock> ResultsLock::of(const ResultsFolder &results)
{
    auto file = results.openLockFile();
    if (!file)
        return file.error();
    return ResultsLock(results, std::move(*file));
}

bool ResultsLock::takeAlone() { return setLock(m_file, placeOfRuns, F_WRLCK, Wait::No); }

void ResultsLock::share() { setLock(m_file, placeOfRuns, F_RDLCK, Wait::Yes); }

void ResultsLock::leave() { setLock(m_file, placeOfRuns, F_UNLCK, Wait::No); }

Result<Descriptor> ResultsLock::claim(const QByteArray &submission) const
{
    auto file = m_results.openLockFile();
    if (file && !setLock(*file, placeOf(submission), F_WRLCK, Wait::No))
        file->close();
    return file;
}

} // namespace pixelplumb
