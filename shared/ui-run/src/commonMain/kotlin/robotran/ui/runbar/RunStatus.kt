package robotran.ui.runbar

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.height
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.WorkshopStatus

/** The space reserved for the status. */
enum class StatusSpace(val lines: Int) {
    /** Two lines with the time next to them. */
    BROAD(2),

    /** One line with the time next to it. */
    LINE(1),
}

/** The status in a sentence, and the time; its height depends only on [room], so that nothing moves. */
@Composable
fun RunStatus(run: RunPaneState, status: WorkshopStatus, room: StatusSpace, modifier: Modifier = Modifier) {
    val height = with(LocalDensity.current) { LINE.toDp() * room.lines }
    Row(modifier.height(height), Arrangement.spacedBy(8.dp), Alignment.CenterVertically) {
        Sentence(run, status, room.lines, Modifier.weight(1f))
        if (!run.untouched) Clock(run)
    }
}

@Composable
private fun Sentence(run: RunPaneState, status: WorkshopStatus, lines: Int, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val elsewhere = seekingStatusText(run, status)
    val wrong = elsewhere == null && isWrong(status)
    Text(
        elsewhere ?: withRobot(run, status, statusText(status)),
        // While seeking, the timeline itself announces the position.
        modifier.testTag(RunTags.STATUS).semantics { if (!run.isSeeking) liveRegion = LiveRegionMode.Polite },
        TextStyles.body.medium.copy(lineHeight = LINE),
        color = if (wrong) colours.error else colours.onPane,
        maxLines = lines,
        overflow = TextOverflow.Ellipsis,
    )
}

/** [label] with the name of the robot that they are about, if there are several. */
private fun withRobot(run: RunPaneState, status: WorkshopStatus, label: String): String {
    val isOfRobot = status is WorkshopStatus.Running || status is WorkshopStatus.Paused ||
        status is WorkshopStatus.Ended || status is WorkshopStatus.Failed || status == WorkshopStatus.Off
    val robot = run.world.robots.takeIf { it.size > 1 && isOfRobot }?.getOrNull(run.watched) ?: return label
    return "${robot.name}: $label"
}

private fun isWrong(status: WorkshopStatus): Boolean =
    status is WorkshopStatus.HasErrors || status is WorkshopStatus.RobotImpossible || status is WorkshopStatus.Failed

@Composable
private fun Clock(run: RunPaneState) {
    val now = RunTexts.clock(spoken, secondsText(run.time))
    Text(
        if (run.inPast) RunTexts.clockOf(spoken, now, secondsText(run.length)) else now,
        Modifier.testTag(RunTags.CLOCK),
        TextStyles.small.copy(lineHeight = LINE),
        color = LocalRobotranColours.current.quiet,
        maxLines = 1,
    )
}

/** The status while another time of the run is shown; null otherwise. */
@Composable
private fun seekingStatusText(run: RunPaneState, status: WorkshopStatus): String? {
    val mark = if (run.isPaused) markAt(run.marks, run.time) else null
    return when {
        run.isSeeking -> RunTexts.statusSeeking(spoken, secondsText(run.time))

        // Where the program stopped says more than a tone that begins at the same moment.
        status is WorkshopStatus.Paused && mark != null && (run.inPast || status.line == 0) -> markText(mark)

        run.isPaused && run.inPast && !run.running -> mark?.let { markText(it) }
            ?: RunTexts.statusPast(spoken)

        else -> null
    }
}

private val LINE = LineHeights.SMALL
