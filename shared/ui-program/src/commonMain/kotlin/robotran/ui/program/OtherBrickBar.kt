package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.ui.program.tags.ProgramTags
import robotran.ui.texts.BrickLabels
import robotran.uikit.*

/** Says that the program is for the other [brick] than the robot [robot] has, with a button that changes the robot. */
@Composable
internal fun OtherBrickBar(brick: BrickKind, robot: String, onUse: () -> Unit) {
    val colours = LocalRobotranColours.current
    val labels = BrickLabels.of(brick)
    Column(
        Modifier
            .fillMaxWidth()
            .background(colours.errorPane)
            .testTag(ProgramTags.OTHER_BRICK)
            .padding(start = 16.dp, end = 8.dp),
    ) {
        Text(
            labels.programIsFor(spoken, robot),
            Modifier.padding(top = 8.dp).announced(),
            TextStyles.body,
            color = colours.error,
        )
        Button(
            labels.use(spoken),
            ProgramTags.USE_OTHER_BRICK,
            ButtonKind.LINK,
            Modifier.align(Alignment.End),
            onClick = onUse,
        )
    }
}
