package robotran.ui.runbar

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.focusable
import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.height
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.ProgressBarRangeInfo
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.disabled
import androidx.compose.ui.semantics.progressBarRangeInfo
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.setProgress
import androidx.compose.ui.semantics.stateDescription
import robotran.runcontrol.TimelineMark
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.workshop.state.RunPaneState
import kotlin.math.abs
import kotlin.math.roundToLong

/** The whole run from left to right with its marks. A touch seeks to that time. Before the first run it is disabled. */
@Composable
internal fun Timeline(state: RunPaneState, onScrub: (Long) -> Unit, modifier: Modifier = Modifier) {
    Row(modifier, verticalAlignment = Alignment.CenterVertically) {
        val previous = state.marks.lastOrNull { it.milliseconds < state.time }?.milliseconds
            ?: 0L.takeIf { state.time > 0 && !state.untouched }
        IconButton(
            RunIcons.PREVIOUS,
            RunTexts.markPrevious(spoken),
            RunTags.MARK_PREVIOUS,
            IconButtonKind.RUN,
            enabled = previous != null,
        ) { previous?.let(onScrub) }
        Track(state, onScrub, Modifier.weight(1f))
        val next =
            state.marks.firstOrNull { it.milliseconds > state.time }?.milliseconds
                ?: state.length.takeIf { state.inPast }
        IconButton(
            RunIcons.NEXT,
            RunTexts.markNext(spoken),
            RunTags.MARK_NEXT,
            IconButtonKind.RUN,
            enabled = next != null,
        ) { next?.let(onScrub) }
    }
}

@Composable
private fun Track(state: RunPaneState, onScrub: (Long) -> Unit, modifier: Modifier) {
    val colours = LocalRobotranColours.current
    val name = RunTexts.timeline(spoken)
    val place = RunTexts.timelinePlace(spoken, secondsText(state.time), secondsText(state.length))
    val here = markAt(state.marks, state.time)?.let { markText(it) }
    val now by rememberUpdatedState(state)
    val scrub by rememberUpdatedState(onScrub)
    val plan = remember { TimelinePlan() }
    Canvas(
        modifier
            .height(Dimensions.TARGET)
            .testTag(RunTags.TIMELINE)
            .focusRing()
            .onKeyEvent { event ->
                if (now.untouched) return@onKeyEvent false
                val step = STEPS[event.key] ?: return@onKeyEvent false
                if (event.type == KeyEventType.KeyDown) scrub((now.time + step).coerceIn(0, now.length))
                true
            }
            .focusable(!state.untouched)
            .semantics {
                contentDescription = name
                if (state.untouched) disabled()
                stateDescription = listOfNotNull(place, here).joinToString(". ")
                progressBarRangeInfo = ProgressBarRangeInfo(state.time.toFloat(), 0f..maxOf(1f, state.length.toFloat()))
                setProgress {
                    if (now.untouched) return@setProgress false
                    scrub(it.roundToLong())
                    true
                }
            }
            .pointerInput(plan) {
                awaitEachGesture {
                    val down = awaitFirstDown()
                    if (now.untouched) return@awaitEachGesture
                    down.consume()

                    fun timeAt(x: Float) = plan.timeAt(x, size.width.toFloat(), now.length)
                    scrub(nearMark(plan, now, down.position.x, size.width.toFloat()) ?: timeAt(down.position.x))
                    do {
                        val event = awaitPointerEvent()
                        val change = event.changes.firstOrNull { it.id == down.id } ?: break
                        val moved = abs(change.position.x - down.position.x) > viewConfiguration.touchSlop
                        if (change.pressed &&
                            (moved || (change.previousPosition != change.position && plan.isDragged))
                        ) {
                            plan.isDragged = true
                            scrub(timeAt(change.position.x))
                        }
                        change.consume()
                    } while (change.pressed)
                    plan.isDragged = false
                }
            },
    ) { drawTimeline(state, plan, colours) }
}

/** The time of the mark at [x]; null if there is none. */
private fun nearMark(plan: TimelinePlan, state: RunPaneState, x: Float, width: Float): Long? =
    state.marks.minByOrNull { abs(plan.placeOf(it.milliseconds, width, state.length) - x) }
        ?.takeIf { abs(plan.placeOf(it.milliseconds, width, state.length) - x) <= plan.grip }
        ?.milliseconds

/** The mark at [time], if any; of several, the rarest. */
internal fun markAt(marks: List<TimelineMark>, time: Long): TimelineMark? =
    marks.filter { abs(it.milliseconds - time) <= NEAR_MILLISECONDS }.minByOrNull { it.kind }

/** The seek distance of the arrow keys, in milliseconds. */
private val STEPS = mapOf(
    Key.DirectionLeft to -100L,
    Key.DirectionRight to 100L,
    Key.PageDown to -1_000L,
    Key.PageUp to 1_000L,
    Key.MoveHome to -Long.MAX_VALUE / 2,
    Key.MoveEnd to Long.MAX_VALUE / 2,
)

/** The max distance of a mark that is announced. */
private const val NEAR_MILLISECONDS = 10L
