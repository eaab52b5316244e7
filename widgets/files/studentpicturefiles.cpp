// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/studentpicturefiles.h"

#include "core/scene/text/byteordermark.h"
#include "widgets/model/studentpicture.h"

namespace pixelplumb {

namespace {

constexpr qint64 sniffed = 256; ///< bytes read to tell JSON from a picture

/// The single local file; empty for anything else.
QString localFileOf(const QMimeData &data)
{
    const QList<QUrl> urls = data.urls();
    return urls.size() == 1 ? urls.constFirst().toLocalFile() : QString();
}

bool isJson(const QString &path)
{
    QFile file(path);
    return path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)
        || (QFileInfo(path).isFile() && file.open(QIODevice::ReadOnly)
            && withoutByteOrderMark(file.read(sniffed)).trimmed().startsWith('{'));
}

} // namespace

QString sceneFileOf(const QMimeData &data)
{
    const QString path = localFileOf(data);
    return !path.isEmpty() && isJson(path) ? path : QString();
}

QString folderOf(const QMimeData &data)
{
    const QString path = localFileOf(data);
    return QFileInfo(path).isDir() ? path : QString();
}

StudentPictureFiles::StudentPictureFiles(StudentPicture *student, QWidget *window)
    : QObject(window)
    , m_student(student)
    , m_window(window)
{
}

bool StudentPictureFiles::accepts(const QMimeData &data)
{
    return !localFileOf(data).isEmpty() || data.hasImage() || data.hasText();
}

void StudentPictureFiles::open()
{
    QFileDialog dialog(m_window, tr("Open a Student's Picture"), m_folder);
    dialog.setObjectName(u"studentPictureDialog"_s);
    dialog.setFileMode(QFileDialog::ExistingFile);
    dialog.setNameFilters(
        {tr("Pictures and rasters (*.png *.ppm *.pgm *.pbm *.bmp *.txt)"), tr("All files (*)")});
    if (dialog.exec() != QDialog::Accepted)
        return;
    m_folder = dialog.directory().absolutePath();
    m_student->open(dialog.selectedFiles().constFirst());
}

void StudentPictureFiles::take(const QMimeData &data)
{
    if (const QString path = localFileOf(data); !path.isEmpty())
        return m_student->open(path);
    const QString origin = tr("clipboard");
    if (data.hasImage()) {
        const auto image = qvariant_cast<QImage>(data.imageData());
        if (!image.isNull())
            return m_student->paste(image, origin);
    }
    m_student->paste(data.text().trimmed().toUtf8() + '\n', origin);
}

} // namespace pixelplumb
