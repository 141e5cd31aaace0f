package robotran.ui.handins

import androidx.compose.foundation.ScrollState
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.key
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInsState

/** One hand-in: its picture, what the runs lacked, its programs, and what the teacher writes to the pupil. */
@Composable
internal fun HandInView(
    state: HandInsState,
    row: HandInRow,
    isWide: Boolean,
    scroll: ScrollState,
    onEvent: (HandInsEvent) -> Unit,
) {
    LaunchedEffect(row.id) { scroll.scrollTo(0) }
    val padding = if (isWide) Space.PAGE else Space.LARGE
    Column(
        Modifier.fillMaxSize().verticalScroll(scroll).padding(padding).testTag(HandInTags.HAND_IN),
        Arrangement.spacedBy(Space.LARGE),
    ) {
        Head(state, row, onEvent)
        key(row.id) {
            if (isWide && row.results != null) {
                Row(horizontalArrangement = Arrangement.spacedBy(Space.PAGE)) {
                    Column(Modifier.weight(1f), Arrangement.spacedBy(Space.LARGE)) {
                        Results(state, row, onEvent)
                    }
                    Column(Modifier.weight(1f), Arrangement.spacedBy(Space.LARGE)) {
                        CommentField(row, onEvent)
                        HandInPrograms(state, row, isWide = true, onEvent)
                    }
                }
            } else {
                Results(state, row, onEvent)
                CommentField(row, onEvent)
                HandInPrograms(state, row, isWide, onEvent)
            }
        }
    }
}

/** The verdict, what is strange, and the ways to other hand-ins. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Head(state: HandInsState, row: HandInRow, onEvent: (HandInsEvent) -> Unit) =
    Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(Space.SMALL)) {
        val index = state.rows.indexOfFirst { it.id == row.id }
        val show = { other: HandInRow -> onEvent(HandInsEvent.HandInChosen(other.id)) }
        FlowRow(
            Modifier.fillMaxWidth(),
            Arrangement.spacedBy(Space.SMALL),
        ) {
            val inMiddle = Modifier.align(Alignment.CenterVertically)
            VerdictMark(row.verdict, inMiddle)
            row.results?.let { Words(runsText(it), inMiddle) }
            state.rows.getOrNull(index - 1)?.let { before ->
                Button(SchoolTexts.handInPrevious(spoken, before.name), HandInTags.HAND_IN_PREVIOUS, ButtonKind.QUIET) {
                    show(before)
                }
            }
            state.rows.getOrNull(index + 1)?.let { next ->
                Button(SchoolTexts.handInNext(spoken, next.name), HandInTags.HAND_IN_NEXT, ButtonKind.QUIET) {
                    show(next)
                }
            }
        }
        for (remark in remarksOf(row)) Words(remark)
        FlowRow(
            horizontalArrangement = Arrangement.spacedBy(Space.SMALL),
            verticalArrangement = Arrangement.spacedBy(Space.SMALL),
        ) {
            row.results?.let { graded ->
                Button(SchoolTexts.handInReplay(spoken), HandInTags.HAND_IN_REPLAY) {
                    onEvent(HandInsEvent.ReplayRequested(row.id, runToLookAt(graded)))
                }
            }
            if (row.hasInputs && row.results != null) {
                Button(SchoolTexts.handInReplayOwn(spoken), HandInTags.HAND_IN_REPLAY_OWN, ButtonKind.SECOND) {
                    onEvent(HandInsEvent.ReplayRequested(row.id, null))
                }
            }
            if (row.graded != null) {
                Button(SchoolTexts.handInFeedback(spoken), HandInTags.HAND_IN_FEEDBACK, ButtonKind.SECOND) {
                    onEvent(HandInsEvent.FeedbackFileRequested(row.id))
                }
            }
            Button(SchoolTexts.handInRemove(spoken), HandInTags.HAND_IN_REMOVE, ButtonKind.QUIET) {
                onEvent(HandInsEvent.HandInRemoved(row.id))
            }
        }
    }

@Composable
private fun Results(state: HandInsState, row: HandInRow, onEvent: (HandInsEvent) -> Unit) {
    val graded = row.results ?: return
    val plan = state.taskOf(row).plan
    val aspect = plan.worlds.first().world.paper.let { (it.width / it.height).toFloat() }
    HandInPicture(
        graded,
        plan,
        Modifier.widthIn(max = PICTURE_HEIGHT * aspect).fillMaxWidth().aspectRatio(aspect),
    )
    HandInRuns(row, graded, plan, onEvent)
}

/** A title of a part of the page. */
@Composable
internal fun PartTitle(label: Label) = Text(label(spoken), Modifier.heading(), TextStyles.lead.strong)

@Composable
internal fun Words(label: String, modifier: Modifier = Modifier) = Text(label, modifier, TextStyles.label)

private val PICTURE_HEIGHT = 380.dp
