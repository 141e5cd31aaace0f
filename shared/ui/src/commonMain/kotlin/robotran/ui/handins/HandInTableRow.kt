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
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.assignments.grading.GradingPlan
import robotran.ui.learning.PLAY_ICON
import robotran.ui.parts.IconTouch
import robotran.ui.resources.Res
import robotran.ui.resources.hand_ins_column_lines
import robotran.ui.resources.hand_ins_column_name
import robotran.ui.resources.hand_ins_column_remarks
import robotran.ui.resources.hand_ins_column_result
import robotran.ui.resources.hand_ins_column_runs
import robotran.ui.resources.hand_ins_column_seconds
import robotran.ui.resources.hand_ins_column_tries
import robotran.ui.resources.hand_ins_replay_of
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LineHeights
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Shapes
import robotran.ui.theme.Space
import robotran.ui.theme.TextSizes
import robotran.ui.theme.focusRing
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInRow

/** The titles of the columns; each row tells screen readers itself what its figures mean. */
@Composable
internal fun ColumnTitles() = Row(
    Modifier.fillMaxWidth().padding(horizontal = Space.SMALL).clearAndSetSemantics { },
    Arrangement.spacedBy(Space.MEDIUM),
    Alignment.Bottom,
) {
    Spacer(Modifier.width(PICTURE_WIDTH))
    Title(Res.string.hand_ins_column_name, Modifier.weight(NAME_WEIGHT))
    Title(Res.string.hand_ins_column_result, Modifier.width(scaled(RESULT_WIDTH)))
    Title(Res.string.hand_ins_column_runs, Modifier.width(scaled(RUNS_WIDTH)))
    Title(Res.string.hand_ins_column_lines, Modifier.width(scaled(FIGURE_WIDTH)), TextAlign.End)
    Title(Res.string.hand_ins_column_tries, Modifier.width(scaled(FIGURE_WIDTH)), TextAlign.End)
    Title(Res.string.hand_ins_column_seconds, Modifier.width(scaled(FIGURE_WIDTH)), TextAlign.End)
    Title(Res.string.hand_ins_column_remarks, Modifier.weight(REMARKS_WEIGHT))
    Spacer(Modifier.width(Dimensions.TARGET))
}

/** A hand-in as a row of the table. A touch opens it. */
@Composable
internal fun HandInTableRow(row: HandInRow, index: Int, plan: GradingPlan, onEvent: (HandInsEvent) -> Unit) {
    val colours = LocalRobotranColours.current
    Row(
        Modifier.fillMaxWidth().border(1.dp, colours.line, Shapes.MEDIUM).background(colours.pane, Shapes.MEDIUM),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        val words = spokenRow(row)
        Row(
            Modifier
                .weight(1f)
                .heightIn(min = Dimensions.TARGET)
                .testTag("hand-in-row-$index")
                .focusRing()
                .clip(Shapes.MEDIUM)
                .clickable(role = Role.Button) { onEvent(HandInsEvent.HandInChosen(row.id)) }
                .clearAndSetSemantics { contentDescription = words }
                .padding(Space.SMALL),
            Arrangement.spacedBy(Space.MEDIUM),
            Alignment.CenterVertically,
        ) {
            HandInPicture(row.results, plan, Modifier.size(PICTURE_WIDTH, PICTURE_HEIGHT))
            NameCell(row)
            Box(Modifier.width(scaled(RESULT_WIDTH))) { VerdictMark(row.verdict) }
            RunsCell(row, plan)
            Figure(row.lines.takeIf { it > 0 }?.toString().orEmpty())
            Figure(triesOf(row)?.toString().orEmpty())
            Figure(row.results?.seconds?.let { secondsText(it) }.orEmpty())
            Column(Modifier.weight(REMARKS_WEIGHT), Arrangement.spacedBy(Space.HAIR)) {
                for (remark in remarksOf(row)) RemarkLine(remark)
            }
        }
        ReplayOfRow(row, index, onEvent)
    }
}

/** Replays a hand-in that can run; otherwise leaves its place free. */
@Composable
internal fun ReplayOfRow(row: HandInRow, index: Int, onEvent: (HandInsEvent) -> Unit) {
    val graded = row.results ?: return Spacer(Modifier.width(Dimensions.TARGET))
    IconTouch(PLAY_ICON, stringResource(Res.string.hand_ins_replay_of, row.name), "hand-in-row-replay-$index", {
        onEvent(HandInsEvent.ReplayRequested(row.id, runToLookAt(graded)))
    })
}

@Composable
private fun RowScope.NameCell(row: HandInRow) = Column(Modifier.weight(NAME_WEIGHT)) {
    val colours = LocalRobotranColours.current
    Text(
        row.name,
        color = colours.onPane,
        fontSize = TextSizes.BODY,
        lineHeight = LineHeights.COMPACT,
        fontWeight = FontWeight.SemiBold,
        maxLines = 2,
        overflow = TextOverflow.Ellipsis,
    )
    if (row.submission.origin != row.name) {
        Text(
            row.submission.origin,
            color = colours.quiet,
            fontSize = TextSizes.SMALL,
            lineHeight = LineHeights.TIGHT,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
    }
}

@Composable
private fun RunsCell(row: HandInRow, plan: GradingPlan) =
    Column(Modifier.width(scaled(RUNS_WIDTH)), Arrangement.spacedBy(Space.TINY)) {
        val graded = row.results ?: return@Column
        if (graded.runs.size > 1) RunMarks(graded, plan)
        Text(
            runsText(graded),
            color = LocalRobotranColours.current.onPane,
            fontSize = TextSizes.SMALL,
            lineHeight = LineHeights.TIGHT,
        )
    }

@Composable
internal fun RemarkLine(words: String) = Text(
    words,
    color = LocalRobotranColours.current.onPane,
    fontSize = TextSizes.SMALL,
    lineHeight = LineHeights.TIGHT,
    maxLines = MAX_REMARK_LINES,
    overflow = TextOverflow.Ellipsis,
)

@Composable
private fun Figure(words: String) = Text(
    words,
    Modifier.width(scaled(FIGURE_WIDTH)),
    color = LocalRobotranColours.current.onPane,
    fontSize = TextSizes.COMPACT,
    textAlign = TextAlign.End,
    maxLines = 1,
)

@Composable
private fun Title(words: StringResource, modifier: Modifier, align: TextAlign = TextAlign.Start) = Text(
    stringResource(words),
    modifier,
    color = LocalRobotranColours.current.quiet,
    fontSize = TextSizes.SMALL,
    fontWeight = FontWeight.Medium,
    textAlign = align,
    maxLines = 1,
    overflow = TextOverflow.Ellipsis,
)

/** Columns grow with the text, but not as much as it: a line more in a cell is better than no remarks. */
@Composable
private fun scaled(width: Dp): Dp = width * LocalDensity.current.fontScale.coerceAtMost(MAX_SCALE)

private val PICTURE_WIDTH = 84.dp
private val PICTURE_HEIGHT = 63.dp
private val RESULT_WIDTH = 136.dp
private val RUNS_WIDTH = 168.dp
private val FIGURE_WIDTH = 56.dp
private const val NAME_WEIGHT = 1f
private const val REMARKS_WEIGHT = 1.4f
private const val MAX_SCALE = 1.5f
private const val MAX_REMARK_LINES = 3
