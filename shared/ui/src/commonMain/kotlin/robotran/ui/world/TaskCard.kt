package robotran.ui.world

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.parts.Icon
import robotran.ui.parts.IconTouch
import robotran.ui.resources.Res
import robotran.ui.resources.task_hide
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.RobotranColours
import robotran.ui.workshop.WorkshopEvent
import robotran.ui.workshop.WorkshopState
import robotran.world.World

/** [sheet] under what is to be done there as long as that is to be seen, or beside it where there is more room. */
@Composable
internal fun WithTask(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier,
    sheet: @Composable (Modifier) -> Unit,
) {
    val isShown = state.taskShown && state.hasTask
    BoxWithConstraints(modifier) {
        if (maxHeight < LEAST_HEIGHT && maxWidth > maxHeight) {
            Row(Modifier.fillMaxSize()) {
                sheet(Modifier.weight(1f).fillMaxHeight())
                if (isShown) TaskCard(state.world, onEvent, Modifier.padding(MARGIN).width(this@BoxWithConstraints.maxWidth * SHARE))
            }
        } else {
            Column(Modifier.fillMaxSize()) {
                if (isShown) TaskCard(state.world, onEvent, Modifier.padding(MARGIN).heightIn(max = this@BoxWithConstraints.maxHeight * SHARE))
                sheet(Modifier.weight(1f).fillMaxWidth())
            }
        }
    }
}

/** What [world] is called and what is to be done there, until it is put away; a long task can be scrolled. */
@Composable
internal fun TaskCard(world: World, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    Row(
        modifier
            .testTag("task-card")
            .clip(RoundedCornerShape(CORNER))
            .background(colours.pane)
            .drawBehind { drawRect(RobotranColours.YELLOW, size = Size(BAR.toPx(), size.height)) },
        verticalAlignment = Alignment.Top,
    ) {
        Column(
            Modifier.weight(1f).verticalScroll(rememberScrollState()).padding(start = 22.dp, top = 12.dp, bottom = 12.dp),
            Arrangement.spacedBy(4.dp),
        ) {
            Text(
                world.title,
                Modifier.testTag("task-title").semantics { heading() },
                color = colours.onPane,
                fontSize = 18.sp,
                lineHeight = 24.sp,
                fontWeight = FontWeight.SemiBold,
            )
            Text(
                world.task.trim(),
                Modifier.fillMaxWidth().testTag("task-text").semantics { liveRegion = LiveRegionMode.Polite },
                color = colours.onPane,
                fontSize = 16.sp,
                lineHeight = 24.sp,
            )
        }
        IconTouch(Icon.CLOSE, stringResource(Res.string.task_hide), "task-hide", { onEvent(WorkshopEvent.TaskShown(false)) })
    }
}

/** Below this height, as on a phone that lies on its side, the task is beside the sheet. */
private val LEAST_HEIGHT = 300.dp
private const val SHARE = 0.45f
private val MARGIN = 8.dp
private val BAR = 6.dp
private val CORNER = 12.dp
