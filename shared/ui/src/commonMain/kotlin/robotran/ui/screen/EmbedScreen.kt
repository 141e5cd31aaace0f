package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.ui.brick.BRICK_ASPECT
import robotran.ui.brick.MIN_BRICK_WIDTH
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.runbar.RunButton
import robotran.ui.runbar.RunStatus
import robotran.ui.runbar.StatusSpace
import robotran.ui.runbar.StopButton
import robotran.ui.school.tags.DocumentTags
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.WorkshopState
import robotran.workshop.state.WorkshopStatus

/** Only the world and the brick, to run a program inside another page; nothing is edited or saved. */
@Composable
internal fun EmbedScreen(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val error = (state.document.dialog as? DocumentDialog.PastingLink)?.error
    Column(modifier.fillMaxSize().background(colours.desk)) {
        if (error != null) {
            Box(Modifier.weight(1f).fillMaxWidth().padding(MARGIN), Alignment.Center) {
                val words = Modifier.testTag(DocumentTags.DOCUMENT_TROUBLE).announced()
                Text(error, words, TextStyles.leadSentence)
            }
        } else {
            WorldAndBrick(state, onEvent, Modifier.weight(1f))
            EmbedBar(state.run, state.status, onEvent)
            RunAnnouncements(state)
        }
    }
}

@Composable
private fun WorldAndBrick(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier) {
    BoxWithConstraints(modifier.fillMaxWidth()) {
        val brickWidth = minOf(maxWidth * BRICK_SHARE, (maxHeight - MARGIN * 2) * BRICK_ASPECT, MAX_BRICK_WIDTH)
        if (brickWidth >= MIN_BRICK_WIDTH) {
            Row(Modifier.fillMaxSize()) {
                SheetStage(state, onEvent, MessageOptions(isEmbedded = true), Modifier.weight(1f), isEmbedded = true)
                WholeBrick(
                    state.run,
                    onEvent,
                    Modifier.padding(end = MARGIN, bottom = MARGIN).width(brickWidth).align(Alignment.Bottom),
                )
            }
        } else {
            Column(Modifier.fillMaxSize(), horizontalAlignment = Alignment.CenterHorizontally) {
                SheetStage(state, onEvent, MessageOptions(isEmbedded = true), Modifier.weight(1f), isEmbedded = true)
                Strip(state.run, onEvent, Modifier.padding(12.dp))
            }
        }
    }
}

/** Run, Stop, reset, and the status. */
@Composable
private fun EmbedBar(run: RunPaneState, status: WorkshopStatus, onEvent: (WorkshopEvent) -> Unit) {
    BoxWithConstraints(Modifier.fillMaxWidth().background(LocalRobotranColours.current.pane)) {
        val room = maxWidth / LocalDensity.current.fontScale.coerceAtLeast(1f)
        Column(Modifier.padding(horizontal = MARGIN, vertical = 8.dp)) {
            if (room < STATUS_BESIDE) {
                RunStatus(run, status, StatusSpace.BROAD, Modifier.fillMaxWidth().padding(bottom = 8.dp))
            }
            Row(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalAlignment = Alignment.CenterVertically) {
                val pulsing = run.untouched && status == WorkshopStatus.Ready
                RunButton(pulsing, { onEvent(RunEvent.RunPressed) }, room = room >= WORDS_FROM)
                StopButton(run.stoppable, { onEvent(RunEvent.StopPressed) }, room = room >= STATUS_BESIDE)
                BarButton(
                    RunIcons.PREVIOUS,
                    BarWords(RunTexts.startOver(spoken), RunTexts.startOverHelp(spoken)),
                    RunTags.START_OVER,
                    enabled = !run.untouched,
                    room = room >= STATUS_BESIDE,
                ) { onEvent(RunEvent.StartedOver) }
                if (room >= STATUS_BESIDE) {
                    RunStatus(run, status, StatusSpace.BROAD, Modifier.weight(1f).padding(start = 4.dp))
                }
            }
        }
    }
}

private val MARGIN = 16.dp
private const val BRICK_SHARE = 0.34f
private val MAX_BRICK_WIDTH = 260.dp

/** From this width on the status is next to the buttons, and they have labels. */
private val STATUS_BESIDE = 640.dp
private val WORDS_FROM = 280.dp
