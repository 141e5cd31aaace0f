package robotran.ui.handins

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInTask

/** A hand-in where there is no room for a table. A touch opens it. */
@Composable
internal fun HandInCard(
    row: HandInRow,
    index: Int,
    task: HandInTask,
    onEvent: (HandInsEvent) -> Unit,
    modifier: Modifier = Modifier,
) {
    val plan = task.plan
    val colours = LocalRobotranColours.current
    Row(
        Modifier.fillMaxWidth().border(1.dp, colours.line, Shapes.MEDIUM).background(colours.pane, Shapes.MEDIUM),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        val words = spokenRow(row, plan)
        val aspect = aspectOf(plan)
        // Beside a picture there is no room for large words, and beside words none for a wide picture.
        val isStacked = LocalDensity.current.fontScale >= LARGE || aspect >= WIDE
        Opening(
            isStacked,
            Modifier
                .weight(1f)
                .heightIn(min = Dimensions.TARGET)
                .testTag(HandInTags.row(index))
                .then(modifier)
                .focusRing()
                .clip(Shapes.MEDIUM)
                .clickable(role = Role.Button) { onEvent(HandInsEvent.HandInChosen(row.id)) }
                .clearAndSetSemantics { contentDescription = words }
                .padding(Space.MEDIUM),
        ) { room ->
            if (!isStacked || row.results != null) {
                val size = if (aspect >= WIDE) {
                    Modifier.widthIn(max = WIDE_WIDTH).fillMaxWidth().aspectRatio(aspect)
                } else {
                    Modifier.size(cardPictureSize(plan))
                }
                HandInPicture(row.results, plan, size)
            }
            Column(room, Arrangement.spacedBy(6.dp)) { CardWords(row, task) }
        }
        Column {
            ReplayOfRow(row, index, onEvent)
            RemoveRow(row, index, onEvent)
        }
    }
}

/** The picture beside or, if [isStacked], above the words. [content] gets what the words need to fill the room. */
@Composable
private fun Opening(isStacked: Boolean, modifier: Modifier, content: @Composable (Modifier) -> Unit) = if (isStacked) {
    Column(modifier, Arrangement.spacedBy(Space.SMALL)) { content(Modifier.fillMaxWidth()) }
} else {
    Row(modifier, Arrangement.spacedBy(Space.MEDIUM)) { content(Modifier.weight(1f)) }
}

@Composable
private fun CardWords(row: HandInRow, task: HandInTask) {
    val colours = LocalRobotranColours.current
    NameLines(row, task.title)
    VerdictMark(row.verdict)
    row.results?.let { graded ->
        if (graded.runs.size > 1) RunMarks(graded, task.plan)
        Text(runsText(graded), style = TextStyles.caption)
    }
    val parameters = listOfNotNull(
        row.lines.takeIf { it > 0 }?.let { SchoolTexts.handInsLines(spoken, it) },
        triesOf(row)?.let { SchoolTexts.handInsTries(spoken, it) },
        row.results?.seconds?.let { SchoolTexts.handInsSeconds(spoken, secondsText(it)) },
    )
    if (parameters.isNotEmpty()) {
        Text(parameters.joinToString(" · "), style = TextStyles.caption, color = colours.quiet)
    }
    for (remark in remarksOf(row)) RemarkLine(remark)
    CommentLine(row)
}

private val WIDE_WIDTH = 320.dp
private const val LARGE = 1.5f

/** From this ratio of width to height on. */
private const val WIDE = 2f
