package robotran.ui.handins

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.RowScope
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.assignments.grading.GradingPlan
import robotran.ui.learning.PLAY_ICON
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInTask

/** The titles of the columns; each row tells screen readers itself what its figures mean. */
@Composable
internal fun ColumnTitles(picture: DpSize) = Row(Modifier.fillMaxWidth().clearAndSetSemantics { }) {
    Row(
        Modifier.weight(1f).padding(horizontal = Space.SMALL),
        Arrangement.spacedBy(Space.MEDIUM),
        Alignment.Bottom,
    ) {
        Spacer(Modifier.width(picture.width))
        Title(SchoolTexts::handInsColumnName, Modifier.weight(NAME_WEIGHT))
        Title(SchoolTexts::handInsColumnResult, Modifier.width(scaled(RESULT_WIDTH)))
        Title(SchoolTexts::handInsColumnRuns, Modifier.width(scaled(RUNS_WIDTH)))
        Title(SchoolTexts::handInsColumnLines, Modifier.width(scaled(FIGURE_WIDTH)), TextAlign.End)
        Title(SchoolTexts::handInsColumnTries, Modifier.width(scaled(FIGURE_WIDTH)), TextAlign.End)
        Title(SchoolTexts::handInsColumnSeconds, Modifier.width(scaled(FIGURE_WIDTH)), TextAlign.End)
        Title(SchoolTexts::handInsColumnRemarks, Modifier.weight(REMARKS_WEIGHT))
    }
    Spacer(Modifier.width(Dimensions.TARGET * 2))
}

/** A hand-in as a row of the table, with a picture of the size [picture]. A touch opens it. */
@Composable
internal fun HandInTableRow(
    row: HandInRow,
    index: Int,
    task: HandInTask,
    picture: DpSize,
    onEvent: (HandInsEvent) -> Unit,
    modifier: Modifier = Modifier,
) {
    val colours = LocalRobotranColours.current
    val plan = task.plan
    Row(
        Modifier.fillMaxWidth().border(1.dp, colours.line, Shapes.MEDIUM).background(colours.pane, Shapes.MEDIUM),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        val words = spokenRow(row, plan)
        Row(
            Modifier
                .weight(1f)
                .heightIn(min = Dimensions.TARGET)
                .testTag(HandInTags.row(index))
                .then(modifier)
                .focusRing()
                .clip(Shapes.MEDIUM)
                .clickable(role = Role.Button) { onEvent(HandInsEvent.HandInChosen(row.id)) }
                .clearAndSetSemantics { contentDescription = words }
                .padding(Space.SMALL),
            Arrangement.spacedBy(Space.MEDIUM),
            Alignment.CenterVertically,
        ) {
            HandInPicture(row.results, plan, Modifier.size(picture))
            NameCell(row, task)
            Box(Modifier.width(scaled(RESULT_WIDTH))) { VerdictMark(row.verdict) }
            RunsCell(row, plan)
            Figure(row.lines.takeIf { it > 0 }?.toString().orEmpty())
            Figure(triesOf(row)?.toString().orEmpty())
            Figure(row.results?.seconds?.let { secondsText(it) }.orEmpty())
            Column(Modifier.weight(REMARKS_WEIGHT), Arrangement.spacedBy(Space.HAIR)) {
                // One text of few lines, so that many rows are in sight; a touch shows all of it.
                val remarks = remarksOf(row)
                if (remarks.isNotEmpty()) RemarkLine(remarks.joinToString(" "))
                CommentLine(row)
            }
        }
        ReplayOfRow(row, index, onEvent)
        RemoveRow(row, index, onEvent)
    }
}

/** Removes a hand-in, which can be undone. */
@Composable
internal fun RemoveRow(row: HandInRow, index: Int, onEvent: (HandInsEvent) -> Unit) {
    val words = SchoolTexts.handInsRemoveOne(spoken, row.name)
    IconButton(EditIcons.DELETE, words, HandInTags.rowRemove(index)) { onEvent(HandInsEvent.HandInRemoved(row.id)) }
}

/** The beginning of the teacher's comment, with a sign. */
@Composable
internal fun CommentLine(row: HandInRow) {
    val words = commentOf(row) ?: return
    Row(horizontalArrangement = Arrangement.spacedBy(Space.TINY), verticalAlignment = Alignment.CenterVertically) {
        val colours = LocalRobotranColours.current
        SmallIcon(COMMENT_ICON, colours.onPane, size = 16.dp)
        Text(words, style = TextStyles.caption.medium, maxLines = 1, overflow = TextOverflow.Ellipsis)
    }
}

/** Replays a hand-in that can run; otherwise leaves its place free. */
@Composable
internal fun ReplayOfRow(row: HandInRow, index: Int, onEvent: (HandInsEvent) -> Unit) {
    val graded = row.results ?: return Spacer(Modifier.width(Dimensions.TARGET))
    IconButton(PLAY_ICON, SchoolTexts.handInsReplayOf(spoken, row.name), HandInTags.rowReplay(index)) {
        onEvent(HandInsEvent.ReplayRequested(row.id, runToLookAt(graded)))
    }
}

@Composable
private fun RowScope.NameCell(row: HandInRow, task: HandInTask) =
    Column(Modifier.weight(NAME_WEIGHT)) { NameLines(row, task.title) }

/** The name, and where it comes from; in a course also [task], unless it is empty. */
@Composable
internal fun NameLines(row: HandInRow, task: String = "") {
    val colours = LocalRobotranColours.current
    val style = TextStyle(
        colours.onPane,
        TextSizes.BODY,
        FontWeight.SemiBold,
        lineHeight = LineHeights.COMPACT,
    )
    ShortenedText(row.name, style, maxLines = 2)
    if (task.isNotEmpty()) RemarkLine(task)
    // The name of the file says nothing more if it is the pupil's.
    val origin = row.submission.origin
    if (!row.hasNamesake && (origin == row.name || origin.substringBeforeLast('.') == row.name)) return
    val small = TextStyle(colours.quiet, TextSizes.SMALL, lineHeight = LineHeights.TIGHT)
    ShortenedText(origin, small, maxLines = 1)
}

@Composable
private fun RunsCell(row: HandInRow, plan: GradingPlan) =
    Column(Modifier.width(scaled(RUNS_WIDTH)), Arrangement.spacedBy(Space.TINY)) {
        val graded = row.results ?: return@Column
        if (graded.runs.size > 1) RunMarks(graded, plan, hasNames = false)
        Text(shortRunsText(graded), style = TextStyles.caption)
    }

@Composable
internal fun RemarkLine(label: String) = Text(
    label,
    style = TextStyles.caption,
    maxLines = MAX_REMARK_LINES,
    overflow = TextOverflow.Ellipsis,
)

@Composable
private fun Figure(label: String) = Text(
    label,
    Modifier.width(scaled(FIGURE_WIDTH)),
    TextStyles.compact,
    textAlign = TextAlign.End,
    maxLines = 1,
)

@Composable
private fun Title(label: Label, modifier: Modifier, align: TextAlign = TextAlign.Start) = Text(
    label(spoken),
    modifier,
    TextStyles.caption.medium,
    color = LocalRobotranColours.current.quiet,
    textAlign = align,
    maxLines = 2,
    overflow = TextOverflow.Ellipsis,
)

/** Columns grow with the text, but not as much as it: a line more in a cell is better than no remarks. */
@Composable
private fun scaled(width: Dp): Dp = width * LocalDensity.current.fontScale.coerceAtMost(MAX_SCALE)

/** A bubble with words. */
private val COMMENT_ICON = Icon.strokes("M4 5H20V16H12L7 20V16H4V5", "M8 9H16", "M8 12H13")
private val RESULT_WIDTH = 180.dp
private val RUNS_WIDTH = 164.dp
private val FIGURE_WIDTH = 80.dp
private const val NAME_WEIGHT = 1f
private const val REMARKS_WEIGHT = 1.4f
private const val MAX_SCALE = 1.5f
private const val MAX_REMARK_LINES = 3
