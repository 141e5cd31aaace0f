package robotran.ui.handins

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.unit.dp
import robotran.assignments.grading.GradedRun
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInRun

/** A mark for each of [runs] in [world] with its seed below. A touch replays the run. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun RunTouches(row: HandInRow, world: String, runs: List<GradedRun>, onEvent: (HandInsEvent) -> Unit) =
    FlowRow(Modifier.fillMaxWidth()) {
        for (run in runs) {
            RunTouch(run, world) {
                onEvent(HandInsEvent.ReplayRequested(row.id, HandInRun(run.world.name, run.grade.seed)))
            }
        }
    }

@Composable
private fun RunTouch(run: GradedRun, world: String, onReplay: () -> Unit) {
    val grade = run.grade
    val words = if (grade.passed) {
        SchoolTexts.handInRunMet(
            spoken,
            world,
            grade.seed,
        )
    } else {
        SchoolTexts.handInRunMissed(spoken, world, grade.seed)
    }
    val colours = LocalRobotranColours.current
    Column(
        Modifier
            .testTag(HandInTags.run(run.world.name, grade.seed))
            .defaultMinSize(Dimensions.TARGET, Dimensions.TARGET)
            .focusRing()
            .clip(Shapes.SMALL)
            .clickable(role = Role.Button, onClick = onReplay)
            .clearAndSetSemantics { contentDescription = words },
        Arrangement.Center,
        Alignment.CenterHorizontally,
    ) {
        Canvas(Modifier.size(MARK)) { drawMark(grade.passed, size.width, colours) }
        Text("${grade.seed}", style = TextStyles.caption, maxLines = 1)
    }
}

private val MARK = 22.dp
