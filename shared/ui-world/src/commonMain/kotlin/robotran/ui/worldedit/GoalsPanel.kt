package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import androidx.compose.ui.unit.dp
import robotran.editing.WorldEditorTexts
import robotran.ui.editing.EditorAction
import robotran.ui.editing.EditorActions
import robotran.ui.editing.HelpText
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.world.Goal
import robotran.world.HasLine
import robotran.world.MarkFigure
import robotran.world.World
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.GoalGroup
import robotran.worldediting.GoalMove
import robotran.worldediting.WorldEdit
import robotran.worldediting.allGoals
import robotran.worldediting.goalTitle
import robotran.worldediting.named
import robotran.worldediting.newGoals
import robotran.worldediting.uniqueName

/** The goals of this world in order, with buttons to add and move them. */
@Composable
internal fun GoalsPanel(editor: EditorScope, onChosen: () -> Unit) {
    val goals = allGoals(editor.world.goals)
    if (goals.isEmpty()) HelpText(WorldEditorTexts.noGoals(spoken))
    goals.forEachIndexed { number, entry ->
        ElementRow(editor, ElementRef(ElementKind.GOAL, number), 20.dp * entry.depth, onChosen = {})
    }
    val chosen = editor.editing.only?.takeIf { it.kind == ElementKind.GOAL }?.number
    if (chosen != null) ChosenGoal(editor, chosen, goals[chosen].goal, onChosen)
    AddGoal(editor, chosen?.takeIf { goals[it].goal.isGroup })
}

@Composable
private fun ChosenGoal(editor: EditorScope, number: Int, goal: Goal, onChosen: () -> Unit) {
    EditorActions(editor, actionsOf(goal, number)) {
        IconWord(EditIcons.PENCIL, WorldEditorTexts.goalChange(spoken), WorldTags.GOAL_CHANGE, onChosen)
    }
    val groups = GoalGroup.entries.map { it to (goalTitle(it.around(goal)))(spoken) }
    MenuRow(
        WorldEditorTexts.goalWrap(spoken),
        groups,
        WorldEditorTexts.choose(spoken),
        WorldTags.GOAL_WRAP,
    ) {
        editor.make(WorldEdit.WrapGoal(number, it))
    }
}

private fun actionsOf(goal: Goal, number: Int): List<EditorAction<WorldEdit>> = listOfNotNull(
    EditorAction(EditIcons.DELETE, WorldEditorTexts::delete, WorldTags.GOAL_DELETE, WorldEdit.Delete),
    EditorAction(EditIcons.UP, WorldEditorTexts::goalUp, WorldTags.GOAL_UP, WorldEdit.MoveGoal(number, GoalMove.UP)),
    EditorAction(
        EditIcons.DOWN,
        WorldEditorTexts::goalDown,
        WorldTags.GOAL_DOWN,
        WorldEdit.MoveGoal(number, GoalMove.DOWN),
    ),
    EditorAction(EditIcons.IN, WorldEditorTexts::goalIn, WorldTags.GOAL_IN, WorldEdit.MoveGoal(number, GoalMove.IN)),
    EditorAction(
        EditIcons.OUT,
        WorldEditorTexts::goalOut,
        WorldTags.GOAL_OUT,
        WorldEdit.MoveGoal(number, GoalMove.OUT),
    ),
    EditorAction(EditIcons.UNGROUP, WorldEditorTexts::goalUnwrap, WorldTags.GOAL_UNWRAP, WorldEdit.UnwrapGoal(number))
        .takeIf { goal.isGroup },
)

/** @param into the group of the new goal; null for none. */
@Composable
private fun AddGoal(editor: EditorScope, into: Int?) {
    val choices = newGoals(editor.world).map { it to goalTitle(it.condition)(spoken) }
    val line = WorldEditorTexts.itemLine(spoken)
    val title = if (into == null) {
        WorldEditorTexts.addGoal(spoken)
    } else {
        WorldEditorTexts.addGoalToGroup(spoken)
    }
    MenuRow("", choices, title, WorldTags.ADD_GOAL) { goal -> editor.make(addition(editor.world, goal, into, line)) }
}

/** A goal for a line refers to it by name; an unnamed line gets one. */
private fun addition(world: World, goal: Goal, into: Int?, lineWord: String): WorldEdit {
    val number = world.marks.indexOfFirst { it.figure is MarkFigure.Line }
    val condition = goal.condition
    if (condition !is HasLine || number < 0) return WorldEdit.AddGoal(goal, into)
    val mark = world.marks[number]
    val name = mark.name ?: world.uniqueName(lineWord)
    val add = WorldEdit.AddGoal(goal.copy(condition = condition.withLine(name)), into)
    if (mark.name != null) return add
    return WorldEdit.Batch(
        listOf(WorldEdit.Change(ElementRef(ElementKind.MARK, number), Element.OfMark(mark).named(name)), add),
    )
}
