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
import robotran.ui.brick.BrickHint
import robotran.ui.brick.brickHintWords
import robotran.ui.documents.KeepingBanner
import robotran.ui.world.TaskCard
import robotran.ui.world.WorldPane
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.WorkshopState
import robotran.world.World

/**
 * The paper, over its upper edge what is to be done there and what the app has to say, and over its foot that the work
 * is not being kept, each until it is read: so neither the paper nor anything else moves when it comes or goes.
 *
 * @param withHint whether what the brick cannot say itself is told here.
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
        WorldPane(state, onEvent)
        Said(state, onEvent, withHint, withNotice)
        if (withNotice) {
            val over = Modifier.align(Alignment.BottomEnd).padding(start = sheetButtonsWidth(state.world)).padding(8.dp)
            KeepingBanner(state.document, onEvent, over)
        }
    }
}

@Composable
private fun BoxWithConstraintsScope.Said(
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
        if (withHint) ClosableHint(state, Modifier.heightIn(max = max))
    }
}

/** How much is left to the sheet's own buttons, which stay free, where they stand beside the paper. */
private fun BoxWithConstraintsScope.sheetButtonsWidth(world: World): Dp = when {
    maxWidth / maxHeight <= (world.paper.width / world.paper.height).toFloat() -> 0.dp
    maxHeight < ONE_COLUMN_HEIGHT -> BUTTONS_WIDTH * 2
    else -> BUTTONS_WIDTH
}

/** Until it is closed; the next one comes again. */
@Composable
internal fun ClosableHint(state: WorkshopState, modifier: Modifier = Modifier) {
    val words = brickHintWords(state.run.brick) ?: return
    var isClosed by remember(words) { mutableStateOf(false) }
    if (!isClosed) Box(modifier) { BrickHint(state.run.brick, onClose = { isClosed = true }) }
}

/** What a column of the sheet's buttons takes, and from which height on there is only one. */
private val BUTTONS_WIDTH = 64.dp
private val ONE_COLUMN_HEIGHT = 240.dp
private val MAX_WIDTH = 560.dp
