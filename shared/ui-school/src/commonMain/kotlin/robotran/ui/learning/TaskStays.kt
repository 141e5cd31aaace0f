package robotran.ui.learning

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableFloatStateOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.layout.LayoutCoordinates
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.testTag
import androidx.compose.ui.text.font.FontWeight
import robotran.ui.school.tags.LearningTags
import robotran.uikit.*

/**
 * [content] that scrolls, such as up to a hint. Once the beginning of the [task] in it has scrolled away, a line of the
 * task lies at the top.
 *
 * @param content is told how to report where the text of the task is.
 */
@Composable
internal fun TaskStays(
    task: String,
    modifier: Modifier,
    content: @Composable (onPlaced: (LayoutCoordinates) -> Unit) -> Unit,
) {
    var top by remember { mutableFloatStateOf(0f) }
    var isAway by remember { mutableStateOf(false) }
    Box(modifier.onGloballyPositioned { top = it.positionInRoot().y }) {
        content { isAway = it.positionInRoot().y < top - SLACK }
        if (isAway) {
            val colours = LocalRobotranColours.current
            // Screen readers have the task itself.
            Column(
                Modifier.fillMaxWidth().background(colours.pane).clearAndSetSemantics {
                    testTag = LearningTags.TASK_LINE
                },
            ) {
                MarkedText(
                    task,
                    Modifier.padding(horizontal = Space.LARGE, vertical = Space.TINY),
                    weight = FontWeight.Medium,
                    maxLines = 1,
                )
                HorizontalDivider()
            }
        }
    }
}

/** In pixels: the text begins with a little air. */
private const val SLACK = 2f
