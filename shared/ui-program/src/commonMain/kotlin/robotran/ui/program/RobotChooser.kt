package robotran.ui.program

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.ui.sheet.RobotColours
import robotran.uikit.*
import robotran.workshop.state.ProgramsState

/** Selects the robot whose programs are shown, in a world with several robots. */
@Composable
internal fun RobotChooser(state: ProgramsState, onChoose: (String) -> Unit) {
    val colours = LocalRobotranColours.current
    val scroll = rememberScrollState()
    Row(
        Modifier
            .fillMaxWidth()
            .background(colours.pane)
            .heightIn(min = Dimensions.TARGET)
            .scrollHint(scroll, Orientation.Horizontal)
            .horizontalScroll(scroll)
            .padding(horizontal = 12.dp)
            .selectableGroup()
            .testTag(ProgramTags.ROBOTS),
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        for (robot in state.robots) {
            PaneChip(
                EditorTexts.robot(spoken, robot.name),
                ProgramTags.robot(robot.name),
                robot.name == state.shownRobot,
                {
                    Canvas(Modifier.size(14.dp)) {
                        drawCircle(RobotColours.brick(robot.colour))
                        drawCircle(RobotColours.edge(robot.colour), style = Stroke(1.dp.toPx()))
                    }
                },
            ) { onChoose(robot.name) }
        }
        if (state.isWorldsOwn) {
            Text(EditorTexts.worldsOwn(spoken), style = TextStyles.small, color = colours.quiet, maxLines = 1)
        }
    }
}
