package robotran.ui.screen

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.BoxWithConstraintsScope
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.brick.BrickHint
import robotran.ui.brick.brickHintWords
import robotran.ui.common.AutosaveBanner
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.texts.ScreenTexts
import robotran.ui.task.OpenTask
import robotran.ui.task.TaskCard
import robotran.ui.world.SHEET_BUTTON_STEP
import robotran.ui.world.WorldMarks
import robotran.ui.world.WorldPane
import robotran.ui.world.hasZoomButtons
import robotran.ui.world.sheetButtonColumns
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.Notice
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.WorkshopState
import robotran.world.World

/**
 * The paper with messages above its edges: the task and the notice at the top, the autosave warning at the bottom. They
 * cover the paper until closed, so nothing moves when they appear.
 *
 * @param withHint whether to show the brick's message here.
 * @param withNotice whether to show notices, and what leads to dialogs; false in a page embedded in another one.
 * @param onWholeBrick shows the whole brick, for the button that a message may speak of; null if it is shown.
 */
@Composable
internal fun CoveredSheet(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    withHint: Boolean = true,
    withNotice: Boolean = true,
    onWholeBrick: (() -> Unit)? = null,
) {
    BoxWithConstraints(modifier) {
        WorldPane(
            state.world,
            state.run.drawn,
            state.sheet,
            onEvent,
            marks = WorldMarks(
                state.sheetPreview,
                state.run.shortfalls,
                isSolved = state.learning.solved != null && state.run.isSolved,
            ),
            canShow = withNotice,
        )
        Messages(state, onEvent, withHint, withNotice, onWholeBrick)
        if (isOutcomeAbove(state) && !isOutcomeReplaced(state)) LowerOutcome(state, onEvent, withNotice)
        if (withNotice) {
            val over = Modifier.align(Alignment.BottomEnd).padding(start = sheetButtonsWidth(state.world)).padding(8.dp)
            AutosaveBanner(state.document, onEvent, over)
        }
    }
}

@Composable
private fun BoxWithConstraintsScope.Messages(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    withHint: Boolean,
    withNotice: Boolean,
    onWholeBrick: (() -> Unit)?,
) {
    val tall = maxHeight * TALL
    val isSmall = this.isSmall
    val hasRoom = maxHeight >= LOW
    val max = if (hasRoom) maxHeight / 2 else tall
    val outcomeMax = if (isSmall) tall else max
    val isOutcomeHere = !isOutcomeAbove(state) && !isOutcomeReplaced(state)
    val isFolded = isTaskFolded(state)
    val tellsTries = !cardTellsTries(state, withNotice)
    Column(
        Modifier.align(
            Alignment.TopEnd,
        ).padding(start = sheetButtonsWidth(state.world)).padding(8.dp).widthIn(max = MAX_WIDTH),
        Arrangement.spacedBy(8.dp),
    ) {
        // The card of a solved task says more.
        val notice = state.notice.takeUnless { it is Notice.WorldSolved && state.learning.solved != null }
        if (withNotice) notice?.let { NoticeBar(it, onEvent, Modifier.align(Alignment.End)) }
        if (isOutcomeHere) {
            OutcomeCard(
                state,
                onEvent,
                Modifier.heightIn(max = outcomeMax),
                withNotice,
                tellsTries = tellsTries,
            )
        }
        if (state.taskShown && state.hasTask) {
            // An assignment says more. It covers more only before the first run, or with a hint.
            val saysMore = state.assignment?.let { state.untouched || it.hints.isNotEmpty() } ?: false
            val room = if (saysMore) tall else max
            TaskCard(
                OpenTask(
                    state.world,
                    state.learning,
                    state.assignment,
                    state.session.goals,
                    canHandIn = withNotice,
                    course = state.course.open.takeIf { withNotice },
                ),
                onEvent,
                Modifier.heightIn(max = room),
                isFolded = isFolded,
                areButtonsFixed = hasRoom,
            )
        }
        if (withHint) ClosableHint(state.run, onWholeBrick, Modifier.heightIn(max = max))
    }
}

/** The card of the outcome above the sheet's buttons, so that it does not cover what it is about. */
@Composable
private fun BoxWithConstraintsScope.LowerOutcome(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    canHandIn: Boolean,
) {
    val buttonsWidth = sheetButtonsWidth(state.world)
    OutcomeCard(
        state,
        onEvent,
        Modifier
            .align(Alignment.BottomEnd)
            .padding(start = buttonsWidth, bottom = if (buttonsWidth == 0.dp) BUTTONS_HEIGHT else 0.dp)
            .padding(8.dp)
            .widthIn(max = MAX_WIDTH)
            .heightIn(max = if (isSmall) maxHeight * TALL else maxHeight / 2),
        canHandIn,
        tellsTries = !cardTellsTries(state, canHandIn),
    )
}

/** On a phone, the card of an assignment is folded from the first run on, unless the pupil has chosen. */
private fun BoxWithConstraintsScope.isTaskFolded(state: WorkshopState): Boolean {
    val assignment = state.assignment ?: return state.taskFolded
    if (!assignment.isOpenForTries) return false
    return assignment.isTaskFolded ?: (isSmall && (assignment.tries.tries > 0 || !state.untouched))
}

/** Whether it is the sheet of a phone. */
private val BoxWithConstraintsScope.isSmall: Boolean get() = maxWidth < SMALL || maxHeight < LOW

/** Whether the card of the task tells the tries, so that no other has to. */
private fun cardTellsTries(state: WorkshopState, canHandIn: Boolean): Boolean =
    canHandIn && state.taskShown && state.hasTask

/**
 * Whether the card of the task is shown in the place of the outcome: that of an assignment, which has the hint, in the
 * place of what was missing, and on a phone any that is not folded in the place of both. Run hides it, so the pupil has
 * asked for it.
 */
private fun BoxWithConstraintsScope.isOutcomeReplaced(state: WorkshopState): Boolean = when {
    !state.taskShown || !state.hasTask -> false
    state.assignment == null -> isSmall && !state.taskFolded
    else -> isSmall || state.learning.solved == null
}

/** Whether what the outcome is about, a place or the robot, is in the upper half of the paper. */
private fun isOutcomeAbove(state: WorkshopState): Boolean {
    val place = state.run.shortfalls.firstNotNullOfOrNull { it.shortfall.place }
    return (place?.y ?: state.session.robot.pose.y) > state.world.paper.height / 2
}

/**
 * The width left for the sheet's own buttons, if they are beside the paper. They stay uncovered unless the words of a
 * card would be broken.
 */
@Composable
private fun BoxWithConstraintsScope.sheetButtonsWidth(world: World): Dp {
    if (maxWidth / maxHeight <= (world.paper.width / world.paper.height).toFloat()) return 0.dp
    val width = SHEET_BUTTON_STEP * sheetButtonColumns(world, hasZoomButtons(maxWidth, maxHeight), maxHeight) + 8.dp
    return if (maxWidth - width >= MIN_CARD * LocalDensity.current.fontScale) width else 0.dp
}

/** Shown until it is closed; the next message appears again. */
@Composable
private fun ClosableHint(run: RunPaneState, onWholeBrick: (() -> Unit)?, modifier: Modifier = Modifier) {
    val words = brickHintWords(run.brick, run.isSolved) ?: return
    var isClosed by remember(words) { mutableStateOf(false) }
    if (isClosed) return
    Box(modifier) {
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
}

/** The height of a row of the sheet's buttons. */
private val BUTTONS_HEIGHT = 64.dp
private val MAX_WIDTH = 560.dp

/** At the default font size, for words of ten letters. */
internal val MIN_CARD = 190.dp

/** A sheet on a phone is narrower than that, or lower. */
private val SMALL = 480.dp
private val LOW = 280.dp

/** The part that a card may cover of a small sheet, and that of an assignment of any sheet. */
private const val TALL = 0.7f
