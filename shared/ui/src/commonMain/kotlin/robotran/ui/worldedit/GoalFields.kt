package robotran.ui.worldedit

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.HasActor
import robotran.world.HasRegion
import robotran.world.WorldLimits
import robotran.worldediting.Element
import robotran.worldediting.ElementRef
import robotran.worldediting.fieldsOf

/** All properties of a goal. */
@Composable
internal fun GoalFields(editor: EditorScope, ref: ElementRef, piece: Element.OfGoal) {
    val goal = piece.goal
    val condition = goal.condition
    val sender = GoalSender(editor, ref, goal)
    TextRow(
        WorldEditorTexts.says(spoken),
        goal.says.orEmpty(),
        WorldLimits.MAXIMUM_SENTENCE_CHARACTERS,
        "field-says",
        { sender.change(goal.copy(says = it.takeIf(String::isNotBlank))) },
        editor::settle,
        mayBeBlank = true,
        hint = WorldEditorTexts.saysHint(spoken),
    )
    val fields = fieldsOf(condition, editor.world.timeLimit)
    if (fields.isNotEmpty()) {
        Column(Modifier.fillMaxWidth()) {
            for (field in fields) GoalFieldRow(sender, field)
        }
    }
    if (goal.isGroup) HelpText(WorldEditorTexts.groupHelp(spoken))
    if (condition is HasActor) WhoField(sender, condition)
    if (condition is HasRegion) FormFields(editor, ref, piece)
}

/** Sends changes of [goal]. */
internal class GoalSender(val making: EditorScope, val thing: ElementRef, private val goal: Goal) {
    fun piece(condition: GoalCondition) = Element.OfGoal(goal.copy(condition = condition))

    fun change(goal: Goal) = making.change(thing, Element.OfGoal(goal))

    fun change(condition: GoalCondition) = making.change(thing, piece(condition))

    fun once(condition: GoalCondition) = making.changeAtOnce(thing, piece(condition))

    fun settle() = making.settle()
}
