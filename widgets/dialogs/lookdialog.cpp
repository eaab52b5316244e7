// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/lookdialog.h"

#include "widgets/look/parts.h"

namespace pixelplumb {

namespace {

constexpr QSize usualSize(560, 520); // logical pixels

/// A box where a value is one of several, else a field.
class LookDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const override
    {
        const QStringList choices = index.data(SceneLook::choicesRole).toStringList();
        if (choices.isEmpty())
            return QStyledItemDelegate::createEditor(parent, option, index);
        auto *box = new QComboBox(parent);
        box->addItems(choices);
        return box;
    }
    void setEditorData(QWidget *editor, const QModelIndex &index) const override
    {
        auto *box = qobject_cast<QComboBox *>(editor);
        if (!box)
            return QStyledItemDelegate::setEditorData(editor, index);
        const QString value = index.data().toString();
        const QString byDefault = index.siblingAtColumn(SceneLook::Default).data().toString();
        box->setCurrentText(value.isEmpty() ? byDefault : value);
    }
    void setModelData(QWidget *editor, QAbstractItemModel *model,
                      const QModelIndex &index) const override
    {
        if (const auto *box = qobject_cast<QComboBox *>(editor))
            model->setData(index, box->currentText());
        else
            QStyledItemDelegate::setModelData(editor, model, index);
    }
};

} // namespace

LookDialog::LookDialog(const Scene &scene, const QString &folder, QWidget *parent)
    : QDialog(parent)
    , m_look(new SceneLook(scene, folder, this))
    , m_tree(new QTreeView(this))
    , m_verdict(new QLabel(this))
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this))
{
    setObjectName(u"lookDialog"_s);
    setWindowTitle(tr("Camera, Light and Materials"));
    auto *hint = new QLabel(
        tr("How the scene is seen. An empty value stands for the default beside it."), this);
    hint->setWordWrap(true);
    named(m_tree, "lookTree", tr("Settings and their values"));
    m_tree->setModel(m_look);
    m_tree->setItemDelegate(new LookDelegate(m_tree));
    m_tree->setEditTriggers(QAbstractItemView::AllEditTriggers);
    m_tree->setAlternatingRowColors(true);
    m_tree->expandAll();
    m_tree->header()->setStretchLastSection(true);
    m_tree->resizeColumnToContents(SceneLook::Key);
    m_tree->setColumnWidth(SceneLook::Value, usualSize.width() * 2 / 5);
    named(m_verdict, "lookVerdict");
    m_verdict->setWordWrap(true);
    m_verdict->setMinimumHeight(m_verdict->fontMetrics().lineSpacing() * 2);
    m_verdict->setAlignment(Qt::AlignTop);
    auto *parts = new QHBoxLayout;
    addButtons(parts);
    withParts(new QVBoxLayout(this), {hint, m_tree, parts, m_verdict, m_buttons}, 8, 16);
    resize(usualSize);

    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_look, &QStandardItemModel::itemChanged, this, &LookDialog::judge);
    connect(m_look, &QStandardItemModel::rowsRemoved, this, &LookDialog::judge);
    judge();
}

void LookDialog::addButtons(QBoxLayout *row)
{
    const auto add = [this, row](const char *name, const QString &text, const QString &tip = {}) {
        QPushButton *button = pushButton(name, text, tip, this);
        button->setAutoDefault(false);
        row->addWidget(button);
        return button;
    };
    connect(add("addLight", tr("Add a &light")), &QPushButton::clicked, this,
            [this] { show(m_look->addLight()); });
    connect(add("addMaterial", tr("Add a &material")), &QPushButton::clicked, this,
            [this] { show(m_look->addMaterial()); });
    m_removal = add("removePart", tr("&Remove"),
                    tr("Removes the selected light, or the selected material if no primitive names "
                       "it or one after it"));
    connect(m_removal, &QPushButton::clicked, this,
            [this] { m_look->remove(m_tree->currentIndex()); });
    const auto update
        = [this] { m_removal->setEnabled(m_look->canRemove(m_tree->currentIndex())); };
    connect(m_tree->selectionModel(), &QItemSelectionModel::currentChanged, m_removal, update);
    update();
    row->addStretch();
}

void LookDialog::show(const QModelIndex &part)
{
    m_tree->expand(part.parent());
    m_tree->expand(part);
    m_tree->scrollTo(part, QAbstractItemView::PositionAtTop);
    m_tree->setCurrentIndex(part);
    judge();
}

void LookDialog::judge()
{
    const Result<ChosenLook> look = m_look->look();
    m_verdict->setText(look ? QString() : look.error().message());
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(look.isOk());
    if (look)
        m_chosen = *look;
}

} // namespace pixelplumb
