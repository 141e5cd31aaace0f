package robotran.ui.learning

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import robotran.learning.Lessons
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.state.LearningPage
import robotran.workshop.state.LearningState
import robotran.workshop.state.TutorialState

/**
 * The number of the step and the completed ones, with a list of all steps; the only visible part of a folded tutorial.
 * While another project is loaded, it leads back to the step and can be closed.
 */
@Composable
fun TutorialStrip(state: LearningState, onEvent: (LearningEvent) -> Unit, modifier: Modifier = Modifier) {
    val tutorial = state.tutorial ?: return
    val colours = LocalRobotranColours.current
    if (tutorial.isFolded && !tutorial.isLoaded) return ReturnStrip(state, tutorial, onEvent, modifier)
    var choosing by remember { mutableStateOf(false) }
    val isLarge = LocalDensity.current.fontScale > LARGE_LESSON
    WordsBeside(
        { StripButtons(tutorial, onEvent) },
        modifier.fillMaxWidth().background(colours.pane).padding(start = 8.dp),
    ) {
        Box {
            Column(
                Modifier
                    .testTag(LearningTags.TUTORIAL_STEPS)
                    .fillMaxWidth()
                    .defaultMinSize(minHeight = Dimensions.TARGET)
                    .focusRing()
                    .clickable(role = Role.DropdownList) { choosing = true }
                    .padding(horizontal = 12.dp, vertical = 6.dp),
            ) {
                val lessons = tutorial.strand.lessons
                val name = LearningTexts.stepOf(
                    spoken,
                    tutorial.strand.title(state.language),
                    lessons.indexOf(tutorial.current) + 1,
                    lessons.size,
                )
                val title = tutorial.current.text(state.language).title
                val words = when {
                    isLarge -> title
                    tutorial.isFolded -> "$title · $name"
                    else -> name
                }
                // Folded, the task has the room.
                val lines = if (tutorial.isFolded && !isLarge) 1 else Int.MAX_VALUE
                Text(words, style = TextStyles.body.medium, maxLines = lines, overflow = TextOverflow.Ellipsis)
                if (tutorial.isFolded) FoldedTask(state, tutorial) else StepDots(state, Modifier.padding(top = 4.dp))
            }
            StepList(state, tutorial, choosing, { choosing = false }, onEvent)
        }
    }
}

/** Its first words, in the place of how many lessons are done. */
@Composable
private fun FoldedTask(state: LearningState, tutorial: TutorialState) = Text(
    state.textOf(tutorial.current).task.replace("`", ""),
    Modifier.testTag(LearningTags.TUTORIAL_TASK),
    TextStyles.caption,
    color = LocalRobotranColours.current.quiet,
    maxLines = if (LocalDensity.current.fontScale > LARGE_LESSON) 1 else FOLDED_LINES,
    overflow = TextOverflow.Ellipsis,
)

@Composable
private fun StripButtons(tutorial: TutorialState, onEvent: (LearningEvent) -> Unit) {
    val folded = tutorial.isFolded
    if (folded && tutorial.hints.isNotEmpty()) {
        // After a try that failed, the hint is one touch away.
        Button(LearningTexts.hint(spoken), LearningTags.FOLDED_HINT, ButtonKind.SECOND) {
            onEvent(LearningEvent.TutorialFolded(false))
        }
    }
    IconButton(MAP_ICON, LearningTexts.map(spoken), LearningTags.LESSON_MAP) {
        onEvent(LearningEvent.PageRequested(LearningPage.MAP))
    }
    IconButton(
        if (folded) UNFOLD_ICON else FOLD_ICON,
        if (folded) LearningTexts.unfold(spoken) else LearningTexts.fold(spoken),
        LearningTags.FOLD_TUTORIAL,
    ) { onEvent(LearningEvent.TutorialFolded(!folded)) }
}

/** Returns to the step with its program and world; the open project is saved. */
@Composable
private fun ReturnStrip(
    state: LearningState,
    tutorial: TutorialState,
    onEvent: (LearningEvent) -> Unit,
    modifier: Modifier,
) {
    val colours = LocalRobotranColours.current
    Row(
        modifier.fillMaxWidth().background(colours.pane).padding(start = 8.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Row(
            Modifier
                .weight(1f)
                .testTag(LearningTags.TUTORIAL_RETURN)
                .defaultMinSize(minHeight = Dimensions.TARGET)
                .focusRing()
                .clickable(role = Role.Button) {
                    onEvent(LearningEvent.StepTried)
                    onEvent(LearningEvent.TutorialFolded(false))
                }
                .padding(horizontal = 12.dp),
            Arrangement.spacedBy(12.dp),
            Alignment.CenterVertically,
        ) {
            SmallIcon(Icon.BACK, colours.onPane)
            Text(
                "${LearningTexts.learningReturn(spoken)}: ${tutorial.current.text(state.language).title}",
                style = TextStyles.body.medium,
                maxLines = 1,
                overflow = TextOverflow.Ellipsis,
            )
        }
        IconButton(Icon.CLOSE, LearningTexts.close(spoken), LearningTags.LEAVE_TUTORIAL) {
            onEvent(LearningEvent.TutorialClosed)
        }
    }
}

@Composable
private fun StepList(
    state: LearningState,
    tutorial: TutorialState,
    shown: Boolean,
    onClose: () -> Unit,
    onEvent: (LearningEvent) -> Unit,
) {
    val colours = LocalRobotranColours.current
    AppMenu(shown, onClose) {
        tutorial.strand.lessons.forEachIndexed { place, step ->
            val done = step.name in state.stepsDone
            val title = step.text(state.language).title
            val named = if (done) {
                LearningTexts.stepNamedDone(spoken, place + 1, title)
            } else {
                "${place + 1} $title"
            }
            MenuItem(
                named,
                LearningTags.tutorialStep(place + 1),
                trailing = if (done) ({ SmallIcon(DONE_ICON, colours.onPane) }) else null,
            ) {
                onClose()
                onEvent(LearningEvent.StepChosen(Lessons.all.indexOf(step)))
            }
        }
    }
}

/** One dot per step: filled if its task is completed, with a ring for the current one. */
@Composable
private fun StepDots(state: LearningState, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val lessons = state.tutorial?.strand?.lessons.orEmpty()
    val done = lessons.map { it.name in state.stepsDone }
    val description = LearningTexts.stepsDone(spoken, done.count { it }, done.size)
    Canvas(
        modifier.testTag(LearningTags.STEP_DOTS).width(DOT_STEP * done.size).height(DOT_STEP).semantics {
            contentDescription = description
        },
    ) {
        done.forEachIndexed {
            place,
            isDone,
            ->
            drawDot(place, isDone, lessons[place] == state.tutorial?.current, colours.onPane)
        }
    }
}

private fun DrawScope.drawDot(index: Int, isDone: Boolean, isShown: Boolean, colour: Color) {
    val middle = Offset((index + 0.5f) * DOT_STEP.toPx(), size.height / 2)
    val radius = DOT_RADIUS.toPx()
    val line = Stroke(1.5.dp.toPx())
    if (isDone) {
        drawCircle(
            colour,
            radius,
            middle,
        )
    } else {
        drawCircle(colour, radius - line.width / 2, middle, style = line)
    }
    if (isShown) drawCircle(colour, radius + 3.dp.toPx(), middle, style = line)
}

/** From this font scale on, a phone has room for two lines only, and the title stands in them. */
internal const val LARGE_LESSON = 1.3f

/** On a phone beside its buttons, most tasks are whole in them. */
private const val FOLDED_LINES = 3
private val DOT_STEP = 18.dp
private val DOT_RADIUS = 4.dp
