package robotran.ui.assignment.making

import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.assignments.doing.HintsOfAssignment
import robotran.projects.Assignment
import robotran.projects.AssignmentHint
import robotran.projects.AssignmentLimits
import robotran.ui.assignment.Quiet
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.world.WorldLimits

/** The hints, in the order in which they are tried. */
@Composable
internal fun HintSection(assignment: Assignment, change: (Assignment) -> Unit) {
    // A hint without words cannot be kept, so a new one becomes one with its first letter.
    var draft by remember { mutableStateOf<AssignmentHint?>(null) }
    val hints = assignment.hints
    Section(SchoolTexts.makeHints(spoken), AssignmentTags.MAKE_HINT_SECTION) {
        Quiet(SchoolTexts.makeHintsHelp(spoken), AssignmentTags.MAKE_HINTS_HELP)
        for (index in 0..<hints.size + if (draft == null) 0 else 1) {
            key(index) {
                HintEditor(
                    hints.getOrNull(index) ?: draft ?: AssignmentHint(""),
                    index,
                    { changed ->
                        if (index < hints.size) {
                            val all = hints.mapIndexed { at, old -> if (at == index) changed else old }
                            change(assignment.copy(hints = all))
                        } else if (changed.text.isBlank()) {
                            draft = changed
                        } else {
                            draft = null
                            change(assignment.copy(hints = hints + changed))
                        }
                    },
                    {
                        if (index == hints.size) draft = null
                        change(assignment.copy(hints = hints.filterIndexed { at, _ -> at != index }))
                    },
                )
            }
        }
        if (draft == null && hints.size < AssignmentLimits.MAXIMUM_HINTS) {
            Button(SchoolTexts.makeHintAdd(spoken), AssignmentTags.MAKE_HINT_ADD, ButtonKind.SECOND) {
                draft =
                    AssignmentHint("")
            }
        }
    }
}

@Composable
private fun HintEditor(hint: AssignmentHint, index: Int, onChange: (AssignmentHint) -> Unit, onRemove: () -> Unit) {
    var words by remember { mutableStateOf(hint.text) }
    // Undo, and removing an earlier hint, bring another text here.
    LaunchedEffect(hint.text) { if (hint.text.isNotEmpty()) words = hint.text }
    Column(
        Modifier
            .fillMaxWidth()
            .testTag(AssignmentTags.makeHint(index))
            .border(1.dp, LocalRobotranColours.current.line, Shapes.MEDIUM)
            .padding(12.dp),
        Arrangement.spacedBy(8.dp),
    ) {
        Field(
            words,
            SchoolTexts.makeHintText(spoken),
            AssignmentTags.makeHintText(index),
            WorldLimits.MAXIMUM_TASK_CHARACTERS,
            lines = 2,
        ) {
            words = it
            if (it.isNotBlank()) onChange(hint.copy(text = it))
        }
        ConditionAndTries(hint, index, onChange)
        Button(
            SchoolTexts.makeHintRemove(spoken),
            AssignmentTags.makeHintRemove(index),
            ButtonKind.QUIET,
            onClick = onRemove,
        )
    }
}

@Composable
private fun ConditionAndTries(hint: AssignmentHint, index: Int, onChange: (AssignmentHint) -> Unit) {
    val all = listOf(null) + HintsOfAssignment.conditions + HintsOfAssignment.wordConditions
    val choices = all.map { it to conditionText(it) }
    val kind = hint.condition?.substringBefore(":")
    val title = SchoolTexts.makeHintWhen(spoken)
    // Beside a long condition in large text, the title would have the width of a letter.
    val isAbove = LocalDensity.current.fontScale > LARGE
    if (isAbove) Quiet(title, AssignmentTags.makeHintWhenTitle(index))
    MenuRow(
        if (isAbove) "" else title,
        choices,
        choices.firstOrNull { it.first == kind }?.second ?: hint.condition.orEmpty(),
        AssignmentTags.makeHintWhen(index),
    ) { chosen ->
        val condition = if (chosen in HintsOfAssignment.wordConditions) "$chosen: repeat" else chosen
        onChange(hint.copy(condition = condition))
    }
    if (kind in HintsOfAssignment.wordConditions) {
        val word = hint.condition.orEmpty().substringAfter(":", "").trim()
        Field(word, SchoolTexts.makeHintWord(spoken), AssignmentTags.makeHintWord(index), MAX_WORD) {
            onChange(hint.copy(condition = "$kind: ${it.trim()}"))
        }
    }
    Row(verticalAlignment = Alignment.CenterVertically) {
        val after = if (hint.afterTries == 1) {
            SchoolTexts.makeHintAfterOne(spoken)
        } else {
            SchoolTexts.makeHintAfter(spoken, hint.afterTries)
        }
        IconButton(MakeIcons.LESS, SchoolTexts.makeHintEarlier(spoken), AssignmentTags.makeHintEarlier(index)) {
            onChange(hint.copy(afterTries = (hint.afterTries - 1).coerceAtLeast(1)))
        }
        Text(after, Modifier.weight(1f, fill = false).testTag(AssignmentTags.makeHintAfter(index)), TextStyles.body)
        IconButton(MakeIcons.MORE, SchoolTexts.makeHintLater(spoken), AssignmentTags.makeHintLater(index)) {
            onChange(hint.copy(afterTries = (hint.afterTries + 1).coerceAtMost(AssignmentLimits.MAXIMUM_TRIES)))
        }
    }
}

/** Until when, and under which name. */
@Composable
internal fun HandInSection(assignment: Assignment, change: (Assignment) -> Unit) {
    Section(SchoolTexts.makeHandIn(spoken), AssignmentTags.MAKE_HAND_IN_SECTION) {
        Field(
            assignment.due,
            SchoolTexts.makeDue(spoken),
            AssignmentTags.MAKE_DUE,
            AssignmentLimits.MAXIMUM_NAME_CHARACTERS,
        ) { change(assignment.copy(due = it)) }
        Field(
            assignment.nameWanted,
            SchoolTexts.makeName(spoken),
            AssignmentTags.MAKE_NAME,
            AssignmentLimits.MAXIMUM_NAME_CHARACTERS,
        ) { change(assignment.copy(nameWanted = it)) }
    }
}

private const val MAX_WORD = 40
