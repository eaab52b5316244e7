// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/delivery.h"

#include "core/grade/class/programdelivery.h"
#include "core/grade/showntext.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::array pictureEnds = {".png", ".ppm", ".bmp", ".txt"};

bool hasPictureEnd(const QByteArray &name)
{
    return std::ranges::any_of(pictureEnds,
                               [&](const char *end) { return name.toLower().endsWith(end); });
}

const SubmittedFile *fileNamed(const SubmissionEntry &entry, const QByteArray &name)
{
    const auto &files = entry.files();
    const auto found = std::ranges::find_if(files, [&](const SubmittedFile &file) {
        return file.name.compare(name, Qt::CaseInsensitive) == 0;
    });
    return found != files.end() ? &*found : nullptr;
}

/// In the order of their extensions; the first is used.
std::vector<const SubmittedFile *> pictureFilesOf(const SubmissionEntry &entry,
                                                  const AssignedScene &scene)
{
    std::vector<const SubmittedFile *> files;
    for (const char *end : pictureEnds) {
        if (const SubmittedFile *file = fileNamed(entry, scene.name.toLatin1() + end))
            files.push_back(file);
    }
    return files;
}

/// "graded shallow.png; shallow.ppm is there, too"; or what was refused besides the file graded.
std::optional<QString> noteOn(const std::vector<const SubmittedFile *> &files,
                              const QString &refusal)
{
    if (files.size() == 1 && !refusal.isEmpty())
        return u"graded %1; %2"_s.arg(escapedName(files.front()->name), refusal);
    if (files.size() < 2)
        return std::nullopt;
    QStringList others;
    for (const SubmittedFile *file : files)
        others += escapedName(file->name);
    const QString taken = others.takeFirst();
    return u"graded %1; %2 %3 there, too"_s.arg(taken, others.join(u" and "_s),
                                                others.size() == 1 ? u"is"_s : u"are"_s);
}

/// Why no file qualifies: an entry with a suitable name is no regular file. Empty: there is no such
/// entry.
template <class IsSuch>
QString refusalIn(const SubmissionEntry &entry, const IsSuch &isSuch)
{
    const auto &refused = entry.refused();
    const auto found = entry.isFolder()
        ? std::ranges::find_if(refused, [&](const RefusedFile &each) { return isSuch(each.name); })
        : refused.begin();
    if (found == refused.end())
        return {};
    return u"%1 is %2; expected an ordinary file; nothing else is read"_s.arg(
        escapedName(found->name), found->kind);
}

QString refusedPicture(const SubmissionEntry &entry, const AssignedScene &scene)
{
    return refusalIn(entry, [&](const QByteArray &name) {
        return std::ranges::any_of(pictureEnds, [&](const char *end) {
            return name.compare(scene.name.toLatin1() + end, Qt::CaseInsensitive) == 0;
        });
    });
}

bool isRun(const SubmittedFile &file)
{
    return (file.isExecutable || isScript(file)) && !hasPictureEnd(file.name);
}

/// The fault where the assignment does not name the file to run.
QString missingProgram(const SubmissionEntry &entry)
{
    QStringList names;
    for (const SubmittedFile &file : entry.files()) {
        if (isRun(file))
            names += escapedName(file.name);
    }
    const QString found = names.size() < 2
        ? u"there is no program"_s
        : u"there are %1 programs: %2"_s.arg(names.size()).arg(fewNames(names));
    return found + u"; expected one executable file, or one that ends in .py"_s;
}

QString missingProgram(const SubmissionEntry &entry, const AssignedProgram &program)
{
    const QString refusal = refusalIn(entry, [&](const QByteArray &name) {
        return program.file.isEmpty() ? !hasPictureEnd(name) : name == program.file.toUtf8();
    });
    if (!refusal.isEmpty())
        return refusal;
    return program.file.isEmpty() ? missingProgram(entry)
                                  : u"there is no ordinary file %1"_s.arg(program.file);
}

/// Why there is neither a picture of the scene nor a program to draw it.
QString whyNothing(const SubmissionEntry &entry, const Assignment &assignment,
                   const AssignedScene &scene)
{
    if (const QString refusal = refusedPicture(entry, scene); !refusal.isEmpty())
        return refusal;
    if (assignment.program)
        return missingProgram(entry, *assignment.program);
    QStringList pictures;
    for (const SubmittedFile &file : entry.files()) {
        if (hasPictureEnd(file.name))
            pictures += escapedName(file.name);
    }
    return pictures.size() < 2 ? u"there is no picture %1.png"_s.arg(scene.name)
                               : u"there are %1 pictures: %2; none is %3.png"_s.arg(pictures.size())
                                     .arg(fewNames(pictures), scene.name);
}

/// The only file for which isSuch is true.
template <class IsSuch>
const SubmittedFile *onlyFile(const SubmissionEntry &entry, const IsSuch &isSuch)
{
    const auto &files = entry.files();
    const auto found = std::ranges::find_if(files, isSuch);
    return std::ranges::count_if(files, isSuch) == 1 ? &*found : nullptr;
}

Delivery deliveredPicture(const SubmissionEntry &entry, const AssignedScene &scene,
                          const SubmittedFile &file)
{
    Delivery delivery;
    delivery.file = escapedName(file.name);
    const Result<QByteArray> content = entry.read(file, largestPictureFileOf(scene.scene.frame));
    if (content)
        take(*content, readStudentOutput(*content, scene.scene, delivery.file), scene.scene.frame,
             delivery);
    else
        refuse(delivery, PictureLack::Unreadable, content.error().message());
    return delivery;
}

const SubmittedFile *programOf(const SubmissionEntry &entry, const AssignedProgram &program)
{
    if (!entry.isFolder() || program.file.isEmpty())
        return onlyFile(entry, isRun);
    return onlyFile(entry,
                    [&](const SubmittedFile &file) { return file.name == program.file.toUtf8(); });
}

} // namespace

std::vector<Delivery> deliveriesOf(const SubmissionEntry &entry, const Assignment &assignment,
                                   const std::stop_token &stop)
{
    const SubmittedFile *program
        = assignment.program ? programOf(entry, *assignment.program) : nullptr;
    const bool isOne = assignment.scenes.size() == 1;
    std::vector<Delivery> deliveries;
    for (const AssignedScene &scene : assignment.scenes) {
        if (program) {
            deliveries.push_back(drawnBy({entry, *program, assignment, scene}, deliveries, stop));
            continue;
        }
        const auto files = pictureFilesOf(entry, scene);
        const SubmittedFile *file = files.empty() ? nullptr : files.front();
        if (!file && isOne)
            file = onlyFile(entry,
                            [](const SubmittedFile &each) { return hasPictureEnd(each.name); });
        if (file) {
            deliveries.push_back(deliveredPicture(entry, scene, *file));
            if (!files.empty()) // of one scene's assignment the only picture may have any name
                deliveries.back().note = noteOn(files, refusedPicture(entry, scene));
        } else {
            refuse(deliveries.emplace_back(), PictureLack::NotThere,
                   whyNothing(entry, assignment, scene));
        }
    }
    return deliveries;
}

} // namespace pixelplumb
