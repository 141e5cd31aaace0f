package robotran.ui.screen

import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.BoxWithConstraintsScope
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import robotran.ui.common.AutosaveBanner
import robotran.ui.world.WorldMarks
import robotran.ui.world.WorldPane
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.WorkshopState

/**
 * The sheet, and below or beside it what there is to say.
 *
 * @param options null if the messages have a place elsewhere.
 * @param isEmbedded whether the page is in another one, where nothing is made of the sheet.
 */
@Composable
internal fun SheetStage(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    options: MessageOptions?,
    modifier: Modifier = Modifier,
    isEmbedded: Boolean = false,
) {
    BoxWithConstraints(modifier) {
        if (options == null) {
            Sheet(state, onEvent, isEmbedded, Modifier.fillMaxSize())
        } else {
            SheetAndMessages(state, onEvent, options, isEmbedded)
        }
        // That work is not kept matters more than what lies below, until it is closed.
        if (!isEmbedded) {
            AutosaveBanner(
                state.document,
                onEvent,
                Modifier.align(Alignment.BottomEnd).padding(Space.SMALL),
            )
        }
    }
}

@Composable
private fun BoxWithConstraintsScope.SheetAndMessages(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    options: MessageOptions,
    isEmbedded: Boolean,
) {
    val plan = StagePlan.of(state.world, maxWidth, maxHeight, LocalDensity.current.fontScale, volume(state))
    when (plan.side) {
        MessageSide.BELOW -> Column {
            Sheet(state, onEvent, isEmbedded, Modifier.weight(1f))
            Messages(state, onEvent, options, Modifier.fillMaxWidth().height(plan.extent))
        }

        MessageSide.BESIDE -> Row {
            Sheet(state, onEvent, isEmbedded, Modifier.weight(1f))
            Messages(state, onEvent, options, Modifier.fillMaxHeight().width(plan.extent))
        }
    }
}

@Composable
private fun Sheet(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, isEmbedded: Boolean, modifier: Modifier) =
    WorldPane(
        state.world,
        state.run.drawn,
        state.sheet,
        onEvent,
        modifier,
        WorldMarks(
            state.sheetPreview,
            // The rest once the goals are looked at.
            state.run.run { if (drawer.tab == DrawerTab.GOALS) shortfalls else missed(shortfalls).take(1) },
            isSolved = state.learning.solved != null && state.run.isSolved,
        ),
        canShow = !isEmbedded,
    )

private fun volume(state: WorkshopState): MessageVolume = when {
    state.assignment != null -> MessageVolume.ASSIGNMENT
    state.hasTask || state.world.goals.isNotEmpty() -> MessageVolume.TASK
    else -> MessageVolume.NOTICES
}
