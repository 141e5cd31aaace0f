package robotran.ui.learning

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.unit.dp
import robotran.learning.Lesson
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*
import robotran.workshop.state.LearningState

/** The [lesson], the one with this [number] in its strand: what it draws, what it is called, and what it teaches. */
@Composable
internal fun LessonCard(
    lesson: Lesson,
    number: Int,
    state: LearningState,
    isNext: Boolean,
    modifier: Modifier = Modifier,
    onClick: () -> Unit,
) {
    val isDone = lesson.name in state.stepsDone
    val brick = state.tutorial?.brick
    val shown = remember(lesson, brick, state.drawings[lesson.name]) {
        ShownLesson(if (brick == null) lesson else lesson.on(brick), state.drawings[lesson.name])
    }
    val text = lesson.text(state.language)
    val skill = text.skill?.let { (if (isDone) LearningTexts::mapCanNow else LearningTexts::mapCanThen)(spoken, it) }
    val name = listOfNotNull(LearningTexts.mapLesson(spoken, number, text.title), skill).joinToString(". ")
    val condition = when {
        isDone -> LearningTexts.mapDone(spoken)
        isNext -> LearningTexts.mapNext(spoken)
        else -> LearningTexts.mapOpen(spoken)
    }
    val spokenAs = modifier.semantics {
        contentDescription = name
        stateDescription = condition
    }
    PictureCard(shown, LessonPictures, LearningTags.lesson(lesson.name), LOOK, onClick, spokenAs, isNext) {
        Words("$number  ${text.title}", skill, isDone, isNext)
    }
}

@Composable
private fun Words(title: String, skill: String?, isDone: Boolean, isNext: Boolean) {
    val colours = LocalRobotranColours.current
    val ink = if (isNext) RobotranColours.ON_YELLOW else colours.onPane
    val height = with(LocalDensity.current) { (LineHeights.LABEL * LINES).toDp() + (LineHeights.SMALL * LINES).toDp() }
    Column(Modifier.heightIn(min = height).clearAndSetSemantics { }, Arrangement.spacedBy(Space.TINY)) {
        Row(horizontalArrangement = Arrangement.spacedBy(Space.SMALL)) {
            Text(title, Modifier.weight(1f), TextStyles.label.strong, color = ink)
            if (isDone) Sign(DONE_ICON, RobotranColours.RUN_GREEN, RobotranColours.ON_YELLOW)
            if (isNext) Sign(PLAY_ICON, RobotranColours.ON_YELLOW, RobotranColours.YELLOW)
        }
        skill?.let { Text(it, style = TextStyles.smallLines, color = if (isNext) ink else colours.quiet) }
    }
}

/** So that no colour stands alone: what is done has a check mark, what is next the sign of Run. */
@Composable
private fun Sign(icon: Icon, ground: Color, colour: Color) {
    val size = SIGN * LocalDensity.current.fontScale
    Box(Modifier.size(size).background(ground, CircleShape), Alignment.Center) {
        SmallIcon(icon, colour, size = SIGN_ICON)
    }
}

private val LOOK = CardLook(4f / 3f, padding = Space.MEDIUM)
private val SIGN = 24.dp
private val SIGN_ICON = 18.dp

/** Room for so many lines of the title and of the skill, so that most cards of a row are of a height. */
private const val LINES = 2
