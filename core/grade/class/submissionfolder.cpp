// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/submissionfolder.h"

#include "core/grade/descriptor.h"
#include "core/grade/filekind.h"
#include "core/grade/showntext.h"

#include <QCryptographicHash>
#include <QFile>

#include <dirent.h>

#include <algorithm>
#include <cerrno>
#include <memory>

namespace pixelplumb {

namespace {

constexpr std::size_t mostFiles = 10'000; ///< of one submission; any more are ignored
constexpr std::size_t mostSubmissions = std::size_t(1) << 20;
constexpr qsizetype longestId = 40; ///< plain characters of a name that an id keeps

struct CloseFolder {
    void operator()(DIR *folder) const { closedir(folder); }
};

/// Not open where it is no folder; links are not followed.
Descriptor openFolder(const Descriptor &parent, const QByteArray &name)
{
    return Descriptor(
        openat(parent.number(), name.constData(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

Descriptor openFolder(const QByteArray &path)
{
    return Descriptor(open(path.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

enum class NameKind { Plain, Hidden };

/// At most `most` names, sorted by their bytes; hidden ones without . and .. themselves.
std::vector<QByteArray> namesIn(const Descriptor &folder, std::size_t most,
                                NameKind kind = NameKind::Plain)
{
    std::vector<QByteArray> names;
    const std::unique_ptr<DIR, CloseFolder> listing(fdopendir(dup(folder.number())));
    while (const dirent *entry = listing ? readdir(listing.get()) : nullptr) {
        const QByteArray name(std::data(entry->d_name));
        const bool isWanted = name.startsWith('.')
            ? kind == NameKind::Hidden && name != "." && name != ".."
            : kind == NameKind::Plain;
        if (isWanted && names.size() < most)
            names.push_back(name);
    }
    std::ranges::sort(names);
    return names;
}

/// Adds the file, or the kind of entry that it is instead.
void add(const Descriptor &folder, const QByteArray &name, std::vector<SubmittedFile> &files,
         std::vector<RefusedFile> &refused)
{
    struct stat status = {};
    if (fstatat(folder.number(), name.constData(), &status, AT_SYMLINK_NOFOLLOW) != 0)
        return;
    if (S_ISREG(status.st_mode))
        files.push_back({name, status.st_size, (status.st_mode & S_IXUSR) != 0});
    else
        refused.push_back({name, fileKindOf(status.st_mode)});
}

bool isPlain(char character)
{
    return (character >= '0' && character <= '9') || (character >= 'A' && character <= 'Z')
        || (character >= 'a' && character <= 'z') || character == '-' || character == '_';
}

/// A backslash is not: it begins an escape.
bool isShown(char32_t character)
{
    return canBeShown(character) && character != U'\\' && character != QChar::ReplacementCharacter;
}

} // namespace

QString escapedName(const QByteArray &name)
{
    QString text;
    for (qsizetype place = 0; place < name.size();) {
        // The shortest piece that is one character; invalid UTF-8 decodes to the replacement
        // character.
        qsizetype length = 1;
        QString character;
        for (; length <= 4 && place + length <= name.size(); ++length) {
            character = QString::fromUtf8(name.sliced(place, length));
            if (!character.contains(QChar::ReplacementCharacter))
                break;
        }
        const QList<uint> codes = character.toUcs4();
        if (length <= 4 && codes.size() == 1 && isShown(codes.front())
            && character.toUtf8() == name.sliced(place, length)) {
            text += character;
            place += length;
            continue;
        }
        text += u"\\x%1"_s.arg(uchar(name[place]), 2, 16, QLatin1Char('0'));
        ++place;
    }
    return text;
}

QByteArray nameShownAs(const QString &escaped)
{
    QByteArray name;
    const QByteArray text = escaped.toUtf8();
    constexpr qsizetype length = 4; // that of \xHH
    for (qsizetype place = 0; place < text.size();) {
        const bool isEscape = text.sliced(place).startsWith("\\x");
        name += isEscape ? QByteArray::fromHex(text.mid(place + 2, 2)) : text.mid(place, 1);
        place += isEscape ? length : 1;
    }
    return name;
}

QString idOf(const QByteArray &name)
{
    QString id;
    for (const char character : name.left(longestId)) {
        // A file name that begins with - would be taken for an option.
        const bool isTaken = isPlain(character) && !(id.isEmpty() && character == '-');
        id += QLatin1Char(isTaken ? character : '_');
    }
    const QByteArray hash = QCryptographicHash::hash(name, QCryptographicHash::Sha256);
    return id + u'-' + QString::fromLatin1(hash.left(8).toHex());
}

SubmissionEntry::SubmissionEntry(QByteArray folder, QByteArray entryName)
    : m_folder(std::move(folder))
    , m_name(std::move(entryName))
{
    const Descriptor parent = openFolder(m_folder);
    const Descriptor own = openFolder(parent, m_name);
    m_isFolder = own.isOpen();
    if (!m_isFolder) {
        add(parent, m_name, m_files, m_refused);
        return;
    }
    for (const QByteArray &each : namesIn(own, mostFiles))
        add(own, each, m_files, m_refused);
}

Result<QByteArray> SubmissionEntry::read(const SubmittedFile &file, std::int64_t largest) const
{
    const auto refusal = [&](const QString &why) {
        return InputError{escapedName(file.name), u"cannot be read: "_s + why, {}};
    };
    const Descriptor parent = openFolder(m_folder);
    const Descriptor own = m_isFolder ? openFolder(parent, m_name) : Descriptor();
    const Descriptor content(openat((m_isFolder ? own : parent).number(), file.name.constData(),
                                    O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status = {};
    if (!content.isOpen() || fstat(content.number(), &status) != 0)
        return refusal(qt_error_string(errno));
    if (!S_ISREG(status.st_mode))
        return refusal(u"it is no file"_s);
    if (status.st_size > largest)
        return refusal(
            u"it has %1 bytes, at most %2 are read"_s.arg(qint64(status.st_size)).arg(largest));
    QFile device;
    if (!device.open(content.number(), QIODevice::ReadOnly | QIODevice::Unbuffered))
        return refusal(device.errorString());
    return device.read(status.st_size);
}

std::optional<QString> SubmissionEntry::pathOf(const SubmittedFile &file) const
{
    const QByteArray bytes = m_folder + '/' + (m_isFolder ? m_name + '/' + file.name : file.name);
    QString path = QFile::decodeName(bytes);
    if (QFile::encodeName(path) != bytes)
        return std::nullopt;
    return path;
}

Result<std::vector<QByteArray>> submissionsIn(const QString &folder)
{
    const Descriptor listed = openFolder(QFile::encodeName(folder));
    if (!listed.isOpen())
        return InputError{folder, u"cannot be read: "_s + qt_error_string(errno),
                          u"a folder of submissions"_s};
    return namesIn(listed, mostSubmissions);
}

std::vector<QByteArray> hiddenIn(const QString &folder)
{
    return namesIn(openFolder(QFile::encodeName(folder)), mostSubmissions, NameKind::Hidden);
}

} // namespace pixelplumb
