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
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.rcxrom.state.BrickState
import robotran.ui.brick.BrickHint
import robotran.ui.brick.brickHintWords
import robotran.ui.documents.AutosaveBanner
import robotran.ui.world.TaskCard
import robotran.ui.world.WorldPane
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.WorkshopState
import robotran.world.World

/**
 * The paper with messages above its edges: the task and the notice at the top, the autosave warning at the bottom. They
 * cover the paper until closed, so nothing moves when they appear.
 *
 * @param withHint whether to show the brick's message here.
 * @param withNotice whether to show notices, and what leads to dialogs; false in a page embedded in another one.
 */
@Composable
internal fun CoveredSheet(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    withHint: Boolean = true,
    withNotice: Boolean = true,
) {
    BoxWithConstraints(modifier) {
        WorldPane(
            state.world,
            state.run.drawn,
            state.sheet,
            onEvent,
            preview = state.sheetPreview,
            canShow = withNotice,
        )
        Messages(state, onEvent, withHint, withNotice)
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
) {
    val max = maxHeight / 2
    Column(
        Modifier.align(
            Alignment.TopEnd,
        ).padding(start = sheetButtonsWidth(state.world)).padding(8.dp).widthIn(max = MAX_WIDTH),
        Arrangement.spacedBy(8.dp),
    ) {
        if (withNotice) state.notice?.let { NoticeBar(it, onEvent) }
        if (state.taskShown && state.hasTask) TaskCard(state.world, onEvent, Modifier.heightIn(max = max))
        if (withHint) ClosableHint(state.run.brick, Modifier.heightIn(max = max))
    }
}

/** The width left for the sheet's own buttons, which stay uncovered, if they are beside the paper. */
private fun BoxWithConstraintsScope.sheetButtonsWidth(world: World): Dp = when {
    maxWidth / maxHeight <= (world.paper.width / world.paper.height).toFloat() -> 0.dp
    maxHeight < ONE_COLUMN_HEIGHT -> BUTTONS_WIDTH * 2
    else -> BUTTONS_WIDTH
}

/** Shown until it is closed; the next message appears again. */
@Composable
internal fun ClosableHint(brick: BrickState, modifier: Modifier = Modifier) {
    val words = brickHintWords(brick) ?: return
    var isClosed by remember(words) { mutableStateOf(false) }
    if (!isClosed) Box(modifier) { BrickHint(brick, onClose = { isClosed = true }) }
}

/** The width of a column of the sheet's buttons, and the min height for a single column. */
private val BUTTONS_WIDTH = 64.dp
private val ONE_COLUMN_HEIGHT = 296.dp
private val MAX_WIDTH = 560.dp
