package robotran.ui.screen

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.brick.state.RunState
import robotran.ui.brick.BrickHint
import robotran.ui.brick.brickHintWords
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.texts.ScreenTexts
import robotran.ui.task.OpenTask
import robotran.ui.task.TaskCard
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.Notice
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.WorkshopState

/**
 * What the messages beside a sheet offer.
 *
 * @property isEmbedded whether the page is in another one: then there are no notices, and nothing that leads to dialogs.
 * @property onWholeBrick shows the whole brick, for the button that a message may speak of; null if it is shown.
 */
internal class MessageOptions(val isEmbedded: Boolean = false, val onWholeBrick: (() -> Unit)? = null)

/**
 * All that is said about the sheet, in a place of its own: the task, what came of a run, notices, the brick's message.
 * What does not fit scrolls; one line of the task stays.
 */
@Composable
internal fun Messages(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    options: MessageOptions,
    modifier: Modifier = Modifier,
) {
    BoxWithConstraints(modifier.testTag(ScreenTags.MESSAGES).padding(Space.SMALL), Alignment.TopCenter) {
        val isBroad = maxWidth >= BESIDE * LocalDensity.current.fontScale
        val isFolded = isTaskFolded(state, isSmall = !isBroad)
        val areButtonsFixed = maxHeight >= LOW
        val taskRoom = Modifier.heightIn(max = maxHeight * if (isFolded) FOLDED_TASK else OPEN_TASK)
        val task = @Composable { place: Modifier -> Task(state, onEvent, options, isFolded, areButtonsFixed, place) }
        val hasTask = state.taskShown && state.hasTask
        when {
            !hasTask -> News(state, onEvent, options, Modifier.widthIn(max = MAX_WIDTH).fillMaxWidth())

            isBroad -> Row(Modifier, Arrangement.spacedBy(Space.SMALL)) {
                task(Modifier.weight(1f))
                News(state, onEvent, options, Modifier.weight(NEWS_WEIGHT))
            }

            else -> Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(Space.SMALL)) {
                task(taskRoom)
                News(state, onEvent, options, Modifier)
            }
        }
    }
}

/** What has just come up. */
@Composable
private fun News(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, options: MessageOptions, modifier: Modifier) {
    val scroll = rememberScrollState()
    Column(
        modifier.testTag(
            ScreenTags.NEWS,
        ).scrollHint(scroll, ground = LocalRobotranColours.current.desk).verticalScroll(scroll),
        Arrangement.spacedBy(Space.SMALL),
    ) {
        if (!options.isEmbedded) {
            // The card of a solved task says more.
            state.notice?.takeUnless { it is Notice.WorldSolved && state.learning.solved != null }
                ?.let { NoticeBar(it, onEvent) }
        }
        // What stopped the program comes before what it has not reached for that.
        val hasFailed = state.run.brick.run is RunState.Failed
        if (hasFailed) ClosableHint(state.run, options.onWholeBrick)
        OutcomeCard(
            state,
            onEvent,
            canHandIn = !options.isEmbedded,
            tellsTries = options.isEmbedded || !state.taskShown || !state.hasTask,
        )
        if (!hasFailed) ClosableHint(state.run, options.onWholeBrick)
    }
}

@Composable
private fun Task(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    options: MessageOptions,
    isFolded: Boolean,
    areButtonsFixed: Boolean,
    modifier: Modifier,
) = TaskCard(
    OpenTask(
        state.world,
        state.learning,
        state.assignment,
        state.session.goals,
        canHandIn = !options.isEmbedded,
        course = state.course.open.takeUnless { options.isEmbedded },
    ),
    onEvent,
    modifier,
    isFolded,
    areButtonsFixed,
)

/** On a phone, the card of an assignment is folded from the first run on, unless the pupil has chosen. */
private fun isTaskFolded(state: WorkshopState, isSmall: Boolean): Boolean {
    val assignment = state.assignment ?: return state.taskFolded
    if (!assignment.isOpenForTries) return false
    return assignment.isTaskFolded ?: (isSmall && (assignment.tries.tries > 0 || !state.untouched))
}

/** Shown until it is closed; the next message appears again. */
@Composable
private fun ClosableHint(run: RunPaneState, onWholeBrick: (() -> Unit)?) {
    val words = brickHintWords(run.brick, run.isSolved) ?: return
    var isClosed by remember(words) { mutableStateOf(false) }
    if (isClosed) return
    BrickHint(run.brick, isSolved = run.isSolved, onClose = { isClosed = true }) {
        if (onWholeBrick != null) {
            IconButton(
                PaneIcons.BRICK_WHOLE,
                ScreenTexts.brickWhole(spoken),
                ScreenTags.BRICK_HINT_WHOLE,
                onClick = onWholeBrick,
            )
        }
    }
}

/** From this width on, at the default font size, the task has a column of its own. */
private val BESIDE = 560.dp
private val MAX_WIDTH = 640.dp

/** From this height on there is room for buttons that do not scroll. */
private val LOW = 280.dp

/** The width of news beside a task that is 1 wide: why a program failed needs sentences. */
private const val NEWS_WEIGHT = 1.4f

/** The part that the task may have above news: who unfolds it wants to read it. */
private const val FOLDED_TASK = 0.5f
private const val OPEN_TASK = 0.7f
