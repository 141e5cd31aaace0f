package robotran.ui.worldedit

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.brick.sensors.SensorKind
import robotran.editing.RobotTexts
import robotran.editing.WorldEditorTexts
import robotran.ui.editing.ChosenName
import robotran.ui.editing.EditorAction
import robotran.ui.editing.EditorActions
import robotran.ui.editing.Form
import robotran.ui.editing.HelpText
import robotran.ui.editing.RowHeading
import robotran.ui.texts.CommonTexts
import robotran.ui.texts.words
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.event.RobotEditEvent
import robotran.worldediting.AlignSide
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.StackOrder
import robotran.worldediting.WorldEdit
import robotran.worldediting.WorldEditing
import robotran.worldediting.canRotate
import robotran.worldediting.fieldsOf
import robotran.worldediting.form
import robotran.worldediting.piece
import robotran.worldediting.turnStep

/** The selection: its actions and properties. */
@Composable
internal fun ChosenPanel(editor: EditorScope) {
    val editing = editor.editing
    if (editing.selection.isEmpty()) {
        HelpText(WorldEditorTexts.chooseFirst(spoken))
        return
    }
    val only = editing.only
    ChosenName(chosenTitle(editing), WorldTags.CHOSEN_NAME)
    EditorActions(editor, actionsOf(editing))
    HorizontalDivider()
    val piece = only?.let { editing.world.piece(it) }
    if (only != null && piece != null) {
        if (piece is Element.OfRobot) BuildButton(editor, only.number)
        Form(editing.fieldsOf(only, ::pluggedWords), editor, editing.error?.let { editErrorText(it) })
    }
    if (editing.hasPlace) {
        RowHeading(if (only != null) WorldEditorTexts.alignPaper(spoken) else WorldEditorTexts.align(spoken))
        EditorActions(editor, ALIGNING)
    }
}

@Composable
private fun BuildButton(editor: EditorScope, robot: Int) {
    if (robot == 0) HelpText(WorldEditorTexts.ownRobot(spoken))
    Button(
        RobotTexts.build(spoken),
        WorldTags.BUILD_ROBOT,
        ButtonKind.EDITOR,
        Modifier.fillMaxWidth().padding(top = 8.dp),
    ) {
        editor.perform(RobotEditEvent.BenchOpened(robot))
    }
}

/** What is on a port, which a program has to name. */
private fun pluggedWords(port: String, sensor: SensorKind?): Label = { language ->
    CommonTexts.sensor(language, port, (sensor?.words ?: WorldEditorTexts::nothing)(language))
}

@Composable
private fun chosenTitle(editing: WorldEditing): String {
    val only = editing.only ?: return WorldEditorTexts.severalChosen(spoken, editing.selection.size)
    return elementText(editing.world, only)
}

private fun actionsOf(editing: WorldEditing): List<EditorAction<WorldEdit>> = buildList {
    fun add(icon: Icon, label: Label, tag: String, edit: WorldEdit) = add(EditorAction(icon, label, tag, edit))
    val turn = editing.turnStep
    val grows = editing.selection.any { it.kind != ElementKind.ROBOT && it.kind != ElementKind.LAMP }
    add(EditIcons.DELETE, WorldEditorTexts::delete, WorldTags.DELETE, WorldEdit.Delete)
    add(EditIcons.COPY, WorldEditorTexts::duplicate, WorldTags.DUPLICATE, WorldEdit.Duplicate)
    if (editing.canRotate) {
        add(EditIcons.TURN_LEFT, WorldEditorTexts::turnLeft, WorldTags.TURN_LEFT, WorldEdit.TurnBy(turn))
        add(EditIcons.TURN_RIGHT, WorldEditorTexts::turnRight, WorldTags.TURN_RIGHT, WorldEdit.TurnBy(-turn))
    }
    if (grows && editing.hasPlace) {
        add(EditIcons.LARGER, WorldEditorTexts::larger, WorldTags.LARGER, WorldEdit.ScaleBy(GROWTH))
        add(EditIcons.SMALLER, WorldEditorTexts::smaller, WorldTags.SMALLER, WorldEdit.ScaleBy(1 / GROWTH))
    }
    if (editing.selection.any { it.kind == ElementKind.MARK }) {
        add(EditIcons.FRONT, WorldEditorTexts::toFront, WorldTags.TO_FRONT, WorldEdit.Restack(StackOrder.TO_FRONT))
        add(EditIcons.UP, WorldEditorTexts::forward, WorldTags.FORWARD, WorldEdit.Restack(StackOrder.FORWARD))
        add(EditIcons.DOWN, WorldEditorTexts::backward, WorldTags.BACKWARD, WorldEdit.Restack(StackOrder.BACK))
        add(EditIcons.BACK, WorldEditorTexts::toBack, WorldTags.TO_BACK, WorldEdit.Restack(StackOrder.TO_BACK))
    }
    if (editing.selection.size > 1) add(EditIcons.GROUP, WorldEditorTexts::group, WorldTags.GROUP, WorldEdit.Group)
    if (editing.groups.any { group -> group.any { it in editing.selection } }) {
        add(EditIcons.UNGROUP, WorldEditorTexts::ungroup, WorldTags.UNGROUP, WorldEdit.Ungroup)
    }
}

private val ALIGNING: List<EditorAction<WorldEdit>> = AlignSide.entries.map {
    EditorAction(alignIcon(it), alignWord(it), WorldTags.align(it), WorldEdit.Align(it))
}

/** Whether a selected element has a place on the sheet. */
private val WorldEditing.hasPlace: Boolean get() = selection.any { world.piece(it)?.form != null }

private val WorldEditing.canRotate: Boolean
    get() = if (selection.size > 1) hasPlace else selection.any { world.piece(it)?.form?.canRotate == true }

private fun alignWord(side: AlignSide): Label = when (side) {
    AlignSide.LEFT -> WorldEditorTexts::alignLeft
    AlignSide.CENTRE -> WorldEditorTexts::alignCentre
    AlignSide.RIGHT -> WorldEditorTexts::alignRight
    AlignSide.TOP -> WorldEditorTexts::alignTop
    AlignSide.MIDDLE -> WorldEditorTexts::alignMiddle
    AlignSide.BOTTOM -> WorldEditorTexts::alignBottom
}
