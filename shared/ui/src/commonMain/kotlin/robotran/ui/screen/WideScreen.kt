package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.offset
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.VerticalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableFloatStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.brick.BRICK_ASPECT
import robotran.ui.brick.BrickFront
import robotran.ui.brick.BrickHint
import robotran.ui.brick.BrickStrip
import robotran.ui.brick.LEAST_BRICK_WIDTH
import robotran.ui.drawer.RunAnnouncer
import robotran.ui.drawer.RunDrawer
import robotran.ui.drawer.TaskAndGoals
import robotran.ui.learning.TutorialPane
import robotran.ui.learning.TutorialStrip
import robotran.ui.program.ProgramPane
import robotran.ui.runbar.RunBar
import robotran.ui.runbar.SoundSwitch
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.workshop.RunEvent
import robotran.ui.workshop.SettingsEvent
import robotran.ui.workshop.WorkshopEvent
import robotran.ui.workshop.WorkshopState
import robotran.ui.world.WorldPane
import robotran.world.SessionInput

/** Tablet and laptop: the tutorial if it is wanted, the program, beside it the desk with paper and brick, the run bar under the desk. */
@Composable
internal fun WideScreen(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit) {
    val tutorial = state.learning.tutorial
    val isReading = tutorial != null && !tutorial.isFolded
    BoxWithConstraints(Modifier.fillMaxSize()) {
        val isRoomy = maxWidth >= TUTORIAL_BESIDE_WIDTH
        Column(Modifier.fillMaxSize()) {
            TopStrip(state, onEvent)
            HorizontalDivider(color = LocalRobotranColours.current.line)
            if (tutorial != null && !isReading) TutorialStrip(state.learning, onEvent)
            Row(Modifier.weight(1f)) {
                if (isReading && isRoomy) {
                    TutorialPane(state.learning, onEvent, Modifier.width(TUTORIAL_WIDTH).fillMaxHeight())
                    VerticalDivider(color = LocalRobotranColours.current.line)
                }
                ProgramAndDesk(state, onEvent, isReading && !isRoomy, Modifier.weight(1f))
            }
        }
    }
}

/** With the tutorial over the program if [isReading]. */
@Composable
private fun ProgramAndDesk(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, isReading: Boolean, modifier: Modifier) {
    var share by rememberSaveable { mutableFloatStateOf(PROGRAM_SHARE) }
    BoxWithConstraints(modifier.fillMaxHeight()) {
        val whole = maxWidth
        val tall = maxHeight
        Row(Modifier.fillMaxSize()) {
            Column(Modifier.width(whole * share).fillMaxHeight()) {
                if (isReading) {
                    TutorialPane(state.learning, onEvent, Modifier.weight(1f))
                    HorizontalDivider(color = LocalRobotranColours.current.line)
                }
                ProgramPane(state, MOST_MISTAKES, onEvent, Modifier.weight(1f))
            }
            Column(Modifier.weight(1f).fillMaxHeight()) {
                Desk(state, onEvent, Modifier.weight(1f))
                RunDrawer(state.run, onEvent, most = tall * MOST_DRAWER_SHARE)
                state.notice?.let { NoticeBar(it, onEvent) }
                RunBar(state, onEvent) { SoundSwitch(state.soundOn, { onEvent(SettingsEvent.SoundSwitched(it)) }) }
            }
        }
        val pixels = with(LocalDensity.current) { whole.toPx() }
        RunAnnouncer(state.run)
        PaneDivider(share, pixels, { share = it }, Modifier.offset(x = whole * share - 12.dp))
    }
}

/** The paper gets all the room that the brick beside it leaves. */
@Composable
private fun Desk(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    BoxWithConstraints(modifier.fillMaxWidth().background(LocalRobotranColours.current.desk)) {
        val room = (maxHeight - MARGIN * 2) * BRICK_ASPECT
        val isTall = room >= LEAST_BRICK_WIDTH
        val brickWidth = minOf(maxWidth * BRICK_SHARE, room).coerceIn(LEAST_BRICK_WIDTH, MOST_BRICK_WIDTH)
        Row(Modifier.fillMaxSize()) {
            WorldPane(state, onEvent, Modifier.weight(1f).fillMaxHeight())
            Column(
                Modifier.width(brickWidth + MARGIN).fillMaxHeight().padding(end = MARGIN, bottom = MARGIN),
                Arrangement.spacedBy(MARGIN, Alignment.Bottom),
            ) {
                TaskAndGoals(state, onEvent)
                BrickHint(state.run.brick)
                // Over an open drawer the whole brick does not fit.
                if (isTall) {
                    BrickFront(
                        state.run.brick,
                        state.down,
                        { onEvent(RunEvent.ButtonPressed(it)) },
                        { onEvent(RunEvent.ButtonReleased(it)) },
                        Modifier.width(brickWidth),
                        state.world.robots[state.run.watched].ports,
                        { port, pressed -> onEvent(RunEvent.SessionTouched(SessionInput.TouchSensor(state.run.watched, port, pressed))) },
                    )
                } else {
                    BrickStrip(state.run.brick, state.down, {
                        onEvent(RunEvent.ButtonPressed(it))
                    }, { onEvent(RunEvent.ButtonReleased(it)) })
                }
            }
        }
    }
}

/** From this width on the tutorial has a column of its own. */
private val TUTORIAL_BESIDE_WIDTH = 1100.dp
private val TUTORIAL_WIDTH = 328.dp
private const val PROGRAM_SHARE = 0.32f
private const val MOST_MISTAKES = 3
private const val MOST_DRAWER_SHARE = 0.6f
private const val BRICK_SHARE = 0.3f
private val MOST_BRICK_WIDTH = 300.dp
private val MARGIN: Dp = 16.dp
