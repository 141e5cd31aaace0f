package robotran.ui.learning

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.semantics.traversalIndex
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*

/**
 * A stop on a path: a lesson, or an assignment of a course.
 *
 * @property note how far the pupil is with it, below its title; null for nothing.
 */
internal class Stop(
    val tag: String,
    val title: String,
    val isDone: Boolean,
    val isNext: Boolean,
    val note: String? = null,
    val onClick: () -> Unit,
)

/** One stop on the map: a green disc with a check mark if it is done, a yellow one if it is next, or an open one. */
@Composable
internal fun Station(stop: Stop, number: Int, height: Dp, modifier: Modifier = Modifier) {
    val state = when {
        stop.isDone -> LearningTexts.mapDone(spoken)
        stop.isNext -> LearningTexts.mapNext(spoken)
        else -> LearningTexts.mapOpen(spoken)
    }
    val condition = listOfNotNull(state, stop.note).joinToString(", ")
    Column(
        modifier
            .height(height)
            .testTag(stop.tag)
            .focusRing()
            .clickable(role = Role.Button, onClick = stop.onClick)
            .semantics {
                contentDescription = "$number ${stop.title}"
                stateDescription = condition
                traversalIndex = number.toFloat()
            }
            .padding(vertical = STATION_GAP),
        Arrangement.Top,
        Alignment.CenterHorizontally,
    ) {
        Disc(stop, number)
        Words(stop)
    }
}

@Composable
private fun Disc(stop: Stop, number: Int) {
    val colours = LocalRobotranColours.current
    val ground = when {
        stop.isNext -> RobotranColours.YELLOW
        stop.isDone -> RobotranColours.RUN_GREEN
        else -> colours.pane
    }
    Box(
        Modifier
            .size(STATION_SIZE)
            .clip(CircleShape)
            .background(ground)
            .border(2.dp, if (stop.isDone || stop.isNext) ground else colours.quiet, CircleShape),
        Alignment.Center,
    ) {
        if (stop.isDone) {
            SmallIcon(DONE_ICON, RobotranColours.ON_YELLOW, size = 28.dp)
        } else {
            Text(
                "$number",
                Modifier.clearAndSetSemantics { },
                TextStyles.lead.strong,
                color = if (stop.isNext) RobotranColours.ON_YELLOW else colours.onPane,
            )
        }
    }
}

@Composable
private fun Words(stop: Stop) {
    val colours = LocalRobotranColours.current
    Text(
        stop.title,
        Modifier.clearAndSetSemantics { }.background(colours.pane).padding(horizontal = 4.dp),
        TextStyles.small.strongIf(stop.isNext).copy(lineHeight = TITLE_LINE),
        textAlign = TextAlign.Center,
        maxLines = TITLE_LINES,
        overflow = TextOverflow.Ellipsis,
    )
    stop.note?.let { note ->
        Text(
            note,
            Modifier.clearAndSetSemantics { }.background(colours.pane).padding(horizontal = 4.dp),
            TextStyles.small.copy(lineHeight = TITLE_LINE),
            color = colours.quiet,
            textAlign = TextAlign.Center,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
    }
}
