package robotran.ui.worldedit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.parts.Icon
import robotran.ui.resources.*
import robotran.world.Goal
import robotran.world.HasLine
import robotran.world.MarkFigure
import robotran.world.World
import robotran.worldediting.Edit
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.GoalGroup
import robotran.worldediting.GoalMove
import robotran.worldediting.allGoals
import robotran.worldediting.named
import robotran.worldediting.newGoals
import robotran.worldediting.uniqueName

/** The goals of this world in order, with buttons to add and move them. */
@Composable
internal fun GoalsPanel(making: EditorScope, onChosen: () -> Unit) {
    val goals = allGoals(making.world.goals)
    if (goals.isEmpty()) Remark(stringResource(Res.string.worldedit_no_goals))
    goals.forEachIndexed { number, entry ->
        ElementRow(making, ElementRef(ElementKind.GOAL, number), 20.dp * entry.depth, onChosen = {})
    }
    val chosen = making.editing.only?.takeIf { it.kind == ElementKind.GOAL }?.number
    if (chosen != null) ChosenGoal(making, chosen, goals[chosen].goal, onChosen)
    AddGoal(making, chosen?.takeIf { goals[it].goal.isGroup })
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun ChosenGoal(making: EditorScope, number: Int, goal: Goal, onChosen: () -> Unit) {
    FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(2.dp)) {
        GoalAction(EditIcons.PENCIL, Res.string.worldedit_goal_change, "goal-change", onChosen)
        GoalAction(EditIcons.DELETE, Res.string.worldedit_delete, "goal-delete") { making.make(Edit.Delete) }
        GoalAction(EditIcons.UP, Res.string.worldedit_goal_up, "goal-up") {
            making.make(Edit.MoveGoal(number, GoalMove.UP))
        }
        GoalAction(EditIcons.DOWN, Res.string.worldedit_goal_down, "goal-down") {
            making.make(Edit.MoveGoal(number, GoalMove.DOWN))
        }
        GoalAction(EditIcons.IN, Res.string.worldedit_goal_in, "goal-in") {
            making.make(Edit.MoveGoal(number, GoalMove.IN))
        }
        GoalAction(EditIcons.OUT, Res.string.worldedit_goal_out, "goal-out") {
            making.make(Edit.MoveGoal(number, GoalMove.OUT))
        }
        if (goal.isGroup) {
            GoalAction(EditIcons.UNGROUP, Res.string.worldedit_goal_unwrap, "goal-unwrap") {
                making.make(Edit.UnwrapGoal(number))
            }
        }
    }
    val groups = GoalGroup.entries.map { it to stringResource(goalTitle(it.around(goal))) }
    MenuRow(
        stringResource(Res.string.worldedit_goal_wrap),
        groups,
        stringResource(Res.string.worldedit_choose),
        "goal-wrap",
    ) {
        making.make(Edit.WrapGoal(number, it))
    }
}

@Composable
private fun GoalAction(icon: Icon, word: StringResource, tag: String, onClick: () -> Unit) =
    IconWord(icon, stringResource(word), tag, onClick)

/** @param into the group of the new goal; null for none. */
@Composable
private fun AddGoal(making: EditorScope, into: Int?) {
    val choices = newGoals(making.world).map { it to stringResource(goalTitle(it.condition)) }
    val line = stringResource(Res.string.worldedit_item_line)
    val title = stringResource(
        if (into == null) {
            Res.string.worldedit_add_goal
        } else {
            Res.string.worldedit_add_goal_to_group
        },
    )
    MenuRow("", choices, title, "add-goal") { goal -> making.make(addition(making.world, goal, into, line)) }
}

/** A goal for a line refers to it by name; an unnamed line gets one. */
private fun addition(world: World, goal: Goal, into: Int?, lineWord: String): Edit {
    val number = world.marks.indexOfFirst { it.figure is MarkFigure.Line }
    val condition = goal.condition
    if (condition !is HasLine || number < 0) return Edit.AddGoal(goal, into)
    val mark = world.marks[number]
    val name = mark.name ?: world.uniqueName(lineWord)
    val add = Edit.AddGoal(goal.copy(condition = condition.withLine(name)), into)
    if (mark.name != null) return add
    return Edit.Batch(listOf(Edit.Change(ElementRef(ElementKind.MARK, number), Element.OfMark(mark).named(name)), add))
}
