// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cases/hardcasespanel.h"

#include "widgets/look/parts.h"
#include "widgets/look/signs.h"
#include "widgets/model/playhead.h"
#include "widgets/studies/cases/hardcasesdetails.h"

namespace pixelplumb {

namespace {

constexpr QSize thumbSize(152, 50); ///< two crops side by side

QString keyOf(const Method &method, const ScanSettings &settings)
{
    const auto text
        = [](std::string_view name) { return QLatin1String(name.data(), int(name.size())); };
    return QStringList{method.id, text(nameOf(settings.arithmetic)),
                       text(nameOf(settings.fillRule)), text(nameOf(settings.rounding))}
        .join(u' ');
}

} // namespace

HardCasesPanel::HardCasesPanel(Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_method(&methods().front())
{
    setObjectName(u"hardCases"_s);
    m_tree = named(new QTreeWidget(this), "hardCasesTree", tr("Hard cases by family"));
    m_tree->setHeaderLabels({tr("current method | truth"), tr("case")});
    m_tree->setIconSize(thumbSize);
    m_tree->setRootIsDecorated(true);
    m_tree->setIndentation(12);
    m_tree->setWordWrap(true);
    m_tree->header()->setStretchLastSection(true);
    m_tree->header()->resizeSection(0, thumbSize.width() + 36);
    m_details = new HardCasesDetails(this);
    auto *splitter = new QSplitter(Qt::Vertical, this);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(m_tree);
    splitter->addWidget(m_details);
    splitter->setStretchFactor(0, 1);
    splitter->setStretchFactor(1, 1);
    withParts(new QVBoxLayout(this), {splitter}, -1, 8);

    onEvents(this, {QEvent::Show}, [this] {
        load();
        followMethod();
    });
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &HardCasesPanel::showChosen);
    // A double click or Enter.
    connect(m_tree, &QTreeWidget::itemActivated, this, [this](const QTreeWidgetItem *item) {
        if (item->parent())
            m_details->open();
    });
    connect(m_details, &HardCasesDetails::openRequested, this, &HardCasesPanel::openRequested);
    connect(m_details, &HardCasesDetails::compareRequested, this,
            &HardCasesPanel::compareRequested);
    connect(m_details, &HardCasesDetails::precisionRequested, this,
            &HardCasesPanel::precisionRequested);
    connect(playhead, &Playhead::tracedChanged, this, &HardCasesPanel::followMethod);
}

void HardCasesPanel::load()
{
    if (m_cases.empty())
        readCases();
}

void HardCasesPanel::readCases()
{
    for (const char *name :
         {"hard_cases.json", "more_cases.json", "shape_cases.json", "effect_cases.json"}) {
        QFile file(u":/cases/"_s + QLatin1String(name));
        if (!file.open(QIODevice::ReadOnly)) {
            m_details->tell(tr("The file of hard cases %1 is not part of this program.")
                                .arg(QLatin1String(name)));
            continue;
        }
        const Result<std::vector<GalleryCase>> gallery = readGallery(file.readAll());
        if (!gallery) {
            m_details->tell(gallery.error().message());
            continue;
        }
        m_cases.insert(m_cases.end(), gallery->begin(), gallery->end());
    }
    fillTree();
}

void HardCasesPanel::fillTree()
{
    QMap<QString, QTreeWidgetItem *> families;
    for (const GalleryCase &each : m_cases) {
        QTreeWidgetItem *&family = families[each.family];
        if (!family) {
            family = new QTreeWidgetItem(m_tree, {each.family});
            family->setFirstColumnSpanned(true);
            family->setFlags(Qt::ItemIsEnabled);
            family->setFont(0, bold(font()));
        }
        auto *item = new QTreeWidgetItem(family, {QString(), each.hardCase.id});
        item->setData(0, Qt::UserRole, int(m_items.size()));
        item->setToolTip(1, each.hardCase.stresses);
        item->setSizeHint(0, thumbSize + QSize(8, 8));
        m_items.push_back(item);
    }
    m_tree->expandAll();
    if (!m_items.empty())
        m_tree->setCurrentItem(m_items.front());
}

bool HardCasesPanel::choose(const QString &id)
{
    const auto found = std::ranges::find_if(
        m_cases, [&id](const GalleryCase &each) { return each.hardCase.id == id; });
    if (found == m_cases.end())
        return false;
    QTreeWidgetItem *item = m_items[std::size_t(found - m_cases.begin())];
    m_tree->setCurrentItem(item);
    m_tree->scrollToItem(item, QAbstractItemView::PositionAtCenter);
    return true;
}

void HardCasesPanel::followMethod()
{
    if (!isVisible() || m_cases.empty())
        return;
    if (const TracedScene *traced = m_playhead->traced()) {
        m_method = traced->method;
        m_settings = traced->scene.settings;
    }
    const auto &pictures = m_pictures[keyOf(*m_method, m_settings)];
    for (std::size_t index = 0; index < m_items.size(); ++index) {
        const auto known = pictures.find(index);
        if (known != pictures.end()) {
            takePicture(index, known->second);
            continue;
        }
        m_items[index]->setIcon(0, {});
        m_items[index]->setText(1, m_cases[index].hardCase.id + u'\n' + tr("not drawn yet"));
    }
    showChosen();
    drawNext();
}

int HardCasesPanel::picturesLeft() const
{
    const auto known = m_pictures.find(keyOf(*m_method, m_settings));
    return int(m_cases.size()) - (known == m_pictures.end() ? 0 : int(known->second.size()));
}

void HardCasesPanel::drawNext()
{
    if (!isVisible())
        return;
    const QString key = keyOf(*m_method, m_settings);
    std::map<std::size_t, HardCasePicture> &pictures = m_pictures[key];
    std::size_t next = 0;
    while (next < m_cases.size() && pictures.contains(next))
        ++next;
    // The chosen case, which is being looked at, comes first.
    const QTreeWidgetItem *current = m_tree->currentItem();
    if (current && current->parent()) {
        const auto chosen = std::size_t(current->data(0, Qt::UserRole).toInt());
        if (!pictures.contains(chosen))
            next = chosen;
    }
    if (next == m_cases.size())
        return;
    m_job.start(
        [hardCase = m_cases[next].hardCase, method = m_method,
         settings = m_settings](const ProgressListener &) -> std::optional<HardCasePicture> {
            return pictureOf(hardCase, *method, settings);
        },
        [this, key, next](const std::optional<HardCasePicture> &picture) {
            m_pictures[key].emplace(next, picture.value_or(HardCasePicture()));
            if (key == keyOf(*m_method, m_settings)) {
                takePicture(next, m_pictures[key].at(next));
                if (m_items[next] == m_tree->currentItem())
                    showChosen();
            }
            drawNext();
        });
}

void HardCasesPanel::takePicture(std::size_t index, const HardCasePicture &picture)
{
    QTreeWidgetItem *item = m_items[index];
    item->setIcon(0, untinted(sideBySide(picture, thumbSize, palette(), devicePixelRatioF())));
    item->setText(1, m_cases[index].hardCase.id + u'\n' + picture.verdict());
    item->setForeground(1,
                        picture.isRight() ? palette().color(QPalette::Text)
                                          : signColour(Sign::Extra, palette()));
}

void HardCasesPanel::showChosen()
{
    const QTreeWidgetItem *current = m_tree->currentItem();
    if (!current || !current->parent())
        return;
    const auto index = std::size_t(current->data(0, Qt::UserRole).toInt());
    const auto &pictures = m_pictures[keyOf(*m_method, m_settings)];
    const auto known = pictures.find(index);
    m_details->show(m_cases[index], *m_method, m_settings,
                    known == pictures.end() ? nullptr : &known->second);
    if (known == pictures.end() && !m_job.isRunning())
        drawNext();
}

} // namespace pixelplumb
