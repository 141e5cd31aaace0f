package robotran.ui.handins

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.semantics
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.GradingProgress
import robotran.workshop.state.HandInOrder
import robotran.workshop.state.HandInVerdict
import robotran.workshop.state.HandInsState

/** How far grading is, how many hand-ins have each verdict, and the order of the table. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun HandInsSummary(state: HandInsState, onEvent: (HandInsEvent) -> Unit) =
    Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(Space.SMALL)) {
        val progress = state.progress
        when {
            state.isReading -> Line(SchoolTexts.handInsReading(spoken))
            progress != null -> Progress(progress, onEvent)
            state.isStopped -> Stopped(state, onEvent)
        }
        FlowRow(
            Modifier.testTag(HandInTags.HAND_INS_COUNTS),
            Arrangement.spacedBy(Space.SMALL),
            Arrangement.spacedBy(Space.SMALL),
        ) {
            // The good news first, as in a heading; the table has those who need help first.
            for ((verdict, count) in state.counts.entries.sortedBy { SUMMARY_ORDER.indexOf(it.key) }) {
                VerdictMark(
                    verdict,
                    Modifier.align(Alignment.CenterVertically).semantics(mergeDescendants = true) { },
                    count,
                )
            }
            if (state.rows.size > 1) Order(state.order) { onEvent(HandInsEvent.OrderChosen(it)) }
        }
    }

@Composable
private fun Progress(progress: GradingProgress, onEvent: (HandInsEvent) -> Unit) =
    Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(Space.MEDIUM), Alignment.CenterVertically) {
        Column(Modifier.weight(1f), Arrangement.spacedBy(Space.TINY)) {
            val left = progress.secondsLeft
            Line(
                when {
                    left == null -> SchoolTexts.handInsProgress(spoken, progress.handIns, progress.of)

                    left < SECONDS_SHOWN -> SchoolTexts.handInsProgressSeconds(
                        spoken,
                        progress.handIns,
                        progress.of,
                        rounded(left),
                    )

                    else -> SchoolTexts.handInsProgressMinutes(
                        spoken,
                        progress.handIns,
                        progress.of,
                        (left + SECONDS_PER_MINUTE / 2) / SECONDS_PER_MINUTE,
                    )
                },
            )
            val colours = LocalRobotranColours.current
            Progress(
                { progress.part },
                Modifier.fillMaxWidth().testTag(HandInTags.HAND_INS_PROGRESS),
                colours.good,
                gap = Space.TINY,
            )
        }
        Button(DocumentTexts.cancel(spoken), HandInTags.HAND_INS_CANCEL, ButtonKind.SECOND) {
            onEvent(HandInsEvent.GradingCancelled)
        }
    }

/** Nobody wants to watch seconds jump to and fro. */
private fun rounded(seconds: Int): Int = if (seconds <= STEP) {
    seconds.coerceAtLeast(1)
} else {
    (seconds + STEP / 2) / STEP * STEP
}

@Composable
private fun Stopped(state: HandInsState, onEvent: (HandInsEvent) -> Unit) =
    Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(Space.MEDIUM), Alignment.CenterVertically) {
        val waiting = state.counts[HandInVerdict.WAITING] ?: 0
        val words = SchoolTexts.handInsStopped(spoken, state.rows.size - waiting, state.rows.size)
        Line(words, Modifier.weight(1f))
        Button(SchoolTexts.handInsGoOn(spoken), HandInTags.HAND_INS_GO_ON, ButtonKind.SECOND) {
            onEvent(HandInsEvent.GradingResumed)
        }
    }

@Composable
private fun Line(label: String, modifier: Modifier = Modifier) = Text(
    label,
    modifier.testTag(HandInTags.HAND_INS_STATUS).announced(),
    TextStyles.body,
    color = LocalRobotranColours.current.onPane,
)

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Order(order: HandInOrder, onChoose: (HandInOrder) -> Unit) = FlowRow(
    Modifier.selectableGroup(),
    Arrangement.spacedBy(Space.SMALL),
) {
    val colours = LocalRobotranColours.current
    val choices = listOf(
        HandInOrder.NAME to SchoolTexts::handInsOrderName,
        HandInOrder.VERDICT to SchoolTexts::handInsOrderVerdict,
    )
    Text(
        SchoolTexts.handInsOrder(spoken),
        Modifier.align(Alignment.CenterVertically),
        TextStyles.compact.medium,
        color = colours.quiet,
    )
    for ((value, words) in choices) {
        Row(
            Modifier
                .testTag(HandInTags.order(value))
                .defaultMinSize(minHeight = Dimensions.TARGET)
                .focusRing()
                .selectable(value == order, role = Role.RadioButton) { onChoose(value) }
                .padding(end = Space.MEDIUM),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            RadioMark(value == order, Modifier.padding(Space.MEDIUM))
            Text(words(spoken), style = TextStyles.compact)
        }
    }
}

private val SUMMARY_ORDER = HandInVerdict.entries.reversed().sortedBy { it == HandInVerdict.WAITING }
private const val SECONDS_PER_MINUTE = 60
private const val SECONDS_SHOWN = 100
private const val STEP = 5
