// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/examplesdialog.h"

#include "core/runs/tracedscene.h"
#include "core/scene/scenefile.h"
#include "widgets/look/parts.h"
#include "widgets/studies/cases/hardcasespicture.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr QSize pictureSize(96, 72); // logical pixels

enum Role { ScenePath = Qt::UserRole, CaseId };

QImage pictureOfScene(const QString &path)
{
    const Result<SceneReading> reading = readSceneFile(path);
    if (!reading)
        return {};
    FrameBuffer frame(reading->scene.frame);
    drawScene(reading->scene, frame);
    return frame.copy();
}

/// Centres a picture in the common room for pictures, as large as it fits; a smaller one is
/// enlarged by a whole number, so that pixels stay pixels.
QPixmap fitted(const QImage &picture, double devicePixelRatio)
{
    const QSize room = pictureSize * devicePixelRatio;
    QPixmap pixmap(room);
    pixmap.fill(Qt::transparent);
    const int times = std::min(room.width() / picture.width(), room.height() / picture.height());
    const QImage shown = times > 0
        ? picture.scaled(picture.size() * times)
        : picture.scaled(room, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    const QSize rest = room - shown.size();
    QPainter(&pixmap).drawImage(rest.width() / 2, rest.height() / 2, shown);
    pixmap.setDevicePixelRatio(devicePixelRatio);
    return pixmap;
}

/// A placeholder for a missing picture, with words on it.
QPixmap inPlaceOfPicture(const QString &words, const QWidget &list)
{
    QPixmap pixmap(pictureSize * list.devicePixelRatioF());
    pixmap.setDevicePixelRatio(list.devicePixelRatioF());
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setFont(list.font());
    painter.setPen(list.palette().color(QPalette::PlaceholderText));
    painter.drawRect(QRect(QPoint(), pictureSize - QSize(1, 1)));
    painter.drawText(QRect(QPoint(), pictureSize), Qt::AlignCenter | Qt::TextWordWrap, words);
    return pixmap;
}

} // namespace

ExamplesDialog::ExamplesDialog(const std::vector<Example> &examples,
                               const std::vector<GalleryCase> &cases, QWidget *parent)
    : QDialog(parent)
    , m_list(new QListWidget(this))
{
    setObjectName(u"examplesDialog"_s);
    setWindowTitle(tr("Examples"));
    named(m_list, "examplesList", tr("Examples"));
    m_list->setIconSize(pictureSize);
    m_list->setWordWrap(true);
    m_list->setSpacing(2);
    addScenes(examples);
    addFamilies(cases);
    m_list->setCurrentRow(0);
    connect(m_list, &QListWidget::itemActivated, this, &ExamplesDialog::choose);

    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] { choose(m_list->currentItem()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    withParts(new QVBoxLayout(this), {m_list, buttons}, 8, 16);
    resize(600, 600);
    drawNext();
}

void ExamplesDialog::addScenes(const std::vector<Example> &examples)
{
    for (const Example &example : examples)
        add(example.title, example.line, [path = example.path] {
            return pictureOfScene(path);
        })->setData(ScenePath, example.path);
}

void ExamplesDialog::addFamilies(const std::vector<GalleryCase> &cases)
{
    QMap<QString, std::vector<const GalleryCase *>> families;
    for (const GalleryCase &each : cases)
        families[each.family].push_back(&each);
    for (auto family = families.begin(); family != families.end(); ++family) {
        const GalleryCase &first = *family->front();
        const QString title = family->size() == 1
            ? tr("Hard case: %1").arg(family.key())
            : tr("Hard cases: %1 (%2)").arg(family.key(), QString::number(family->size()));
        add(title, first.why, [hardCase = first.hardCase] {
            return pictureOf(hardCase, methods().front(), ScanSettings()).drawn;
        })->setData(CaseId, first.hardCase.id);
    }
}

QListWidgetItem *ExamplesDialog::add(const QString &title, const QString &line,
                                     const Picture &picture)
{
    auto *item = new QListWidgetItem(title + u'\n' + line, m_list);
    m_pictures.push_back(picture);
    showPicture(m_list->row(item), {}, tr("Picture to be drawn"));
    return item;
}

int ExamplesDialog::picturesLeft() const
{
    return int(std::ranges::count_if(m_pictures, [](const Picture &each) { return bool(each); }));
}

/// Visible rows from the top come first, then the rest.
int ExamplesDialog::nextRow() const
{
    const QRect inSight = m_list->viewport()->rect();
    int next = -1;
    for (int row = 0; row < m_list->count(); ++row) {
        if (isDrawn(row))
            continue;
        if (m_list->visualItemRect(m_list->item(row)).intersects(inSight))
            return row;
        if (next < 0)
            next = row;
    }
    return next;
}

/// Shows a picture, or words in place of a null one.
void ExamplesDialog::showPicture(int row, const QImage &picture, const QString &words)
{
    QListWidgetItem *item = m_list->item(row);
    const bool isThere = !picture.isNull();
    item->setIcon(untinted(isThere ? fitted(picture, devicePixelRatioF())
                                   : inPlaceOfPicture(words, *m_list)));
    item->setData(Qt::AccessibleDescriptionRole, isThere ? QString() : words);
}

void ExamplesDialog::drawNext()
{
    const int row = nextRow();
    if (row < 0)
        return;
    showPicture(row, {}, tr("Picture is being drawn…"));
    m_drawing.start(
        [draw = m_pictures[std::size_t(row)]](const ProgressListener &) { return draw(); },
        [this, row](const QImage &picture) {
            m_pictures[std::size_t(row)] = {};
            showPicture(row, picture, tr("No picture"));
            drawNext();
        });
}

void ExamplesDialog::choose(const QListWidgetItem *item)
{
    if (!item)
        return;
    accept();
    if (const QString path = item->data(ScenePath).toString(); !path.isEmpty())
        emit sceneChosen(path);
    else
        emit caseChosen(item->data(CaseId).toString());
}

} // namespace pixelplumb
