package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
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
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/**
 * Says that the program is for the other [brick] than the robot has, with what helps: the program to begin with in this
 * world, and a robot with that brick.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun OtherBrickBar(brick: BrickKind, onUse: () -> Unit) {
    val colours = LocalRobotranColours.current
    val labels = BrickLabels.of(brick)
    val beginning = LocalBeginning.current
    Column(
        Modifier
            .fillMaxWidth()
            .background(colours.errorPane)
            .testTag(ProgramTags.OTHER_BRICK)
            .padding(start = 16.dp, end = 8.dp, bottom = if (beginning == null) 0.dp else 8.dp),
    ) {
        Text(
            labels.programIsFor(spoken),
            Modifier.padding(top = 8.dp).announced(),
            TextStyles.body,
            color = colours.error,
        )
        FlowRow(
            Modifier.fillMaxWidth(),
            Arrangement.spacedBy(8.dp, if (beginning == null) Alignment.End else Alignment.Start),
        ) {
            if (beginning != null) {
                val words = CommonTexts.worldProgram(spoken)
                Button(words, ProgramTags.OTHER_BRICK_BEGINNING, ButtonKind.SECOND, onClick = beginning)
            }
            Button(
                labels.use(spoken),
                ProgramTags.USE_OTHER_BRICK,
                ButtonKind.LINK,
                Modifier.align(Alignment.CenterVertically),
                onClick = onUse,
            )
        }
    }
}
