package robotran.ui.learning

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
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
internal fun LessonCard(lesson: Lesson, number: Int, state: LearningState, isNext: Boolean, onClick: () -> Unit) {
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
    val spokenAs = Modifier.semantics {
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
    Column(Modifier.clearAndSetSemantics { }, Arrangement.spacedBy(Space.TINY)) {
        if (isNext) Text(LearningTexts.mapNextSign(spoken), style = TextStyles.small.strong, color = ink)
        Row(horizontalArrangement = Arrangement.spacedBy(Space.SMALL)) {
            Text(title, Modifier.weight(1f), TextStyles.label.strong, color = ink)
            if (isDone) DoneSign()
        }
        skill?.let { Text(it, style = TextStyles.smallLines, color = if (isNext) ink else colours.quiet) }
    }
}

@Composable
private fun DoneSign() = Box(
    Modifier.size(SIGN).background(RobotranColours.RUN_GREEN, CircleShape),
    Alignment.Center,
) {
    SmallIcon(DONE_ICON, RobotranColours.ON_YELLOW, size = SIGN_ICON)
}

private val LOOK = CardLook(4f / 3f, padding = Space.MEDIUM)
private val SIGN = 24.dp
private val SIGN_ICON = 18.dp
