package robotran.ui.learning

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.grid.itemsIndexed
import androidx.compose.foundation.lazy.grid.rememberLazyGridState
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.dp
import robotran.learning.Lessons
import robotran.learning.Strand
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningState

/**
 * All lessons as a gallery, in their strands: each is the picture of what it draws, once solved of what the pupil's robot
 * drew. The yellow one is next. A touch opens a lesson.
 */
@Composable
internal fun LessonMapPage(state: LearningState, onEvent: (WorkshopEvent) -> Unit) {
    val cards = rememberLazyGridState(beginOf(state))
    Page(LearningTexts.map(spoken), LearningTags.MAP_PAGE, {
        onEvent(LearningEvent.PageClosed)
    }, cards, maxWidth = 1280.dp) {
        CardGrid(pictureCardColumns(CARD_WIDTH), cards, LearningTags.MAP) {
            wholeRow("where") { WhereOne(state) }
            for (strand in Lessons.strands) {
                wholeRow(strand.name) { StrandHead(strand, state) }
                itemsIndexed(strand.lessons, { _, lesson -> lesson.name }) { place, lesson ->
                    val index = Lessons.indexOf(lesson)
                    LessonCard(lesson, place + 1, state, isNext = state.nextLesson == index) {
                        onEvent(LearningEvent.LessonChosen(index))
                    }
                }
            }
            wholeRow("courses") { MyCourses { onEvent(CourseEvent.ListRequested) } }
        }
    }
}

/** The element of the grid with which the page begins: the next lesson is in sight, and what is just above it. */
private fun beginOf(state: LearningState): Int {
    val next = state.nextLesson ?: return 0
    val strand = Lessons.strandOf(Lessons.all[next])
    val heads = Lessons.strands.indexOf(strand) + 1
    val place = strand.lessons.indexOf(Lessons.all[next])
    if (heads == 1 && place <= CARDS_ABOVE) return 0
    return heads + next - minOf(place, CARDS_ABOVE) + if (place > CARDS_ABOVE) 1 else 0
}

/** How far the pupil is, and what to do next. */
@Composable
private fun WhereOne(state: LearningState) {
    val done = Lessons.all.count { it.name in state.stepsDone }
    val words = when (done) {
        0 -> LearningTexts.mapBegin(spoken)
        Lessons.all.size -> LearningTexts.mapAllDone(spoken, done)
        else -> LearningTexts.mapGoOn(spoken, done, Lessons.all.size)
    }
    Text(words, style = TextStyles.leadSentence)
}

@Composable
private fun StrandHead(strand: Strand, state: LearningState) {
    val colours = LocalRobotranColours.current
    val done = strand.lessons.count { it.name in state.stepsDone }
    Row(
        Modifier.testTag(LearningTags.strand(strand.name)).padding(top = Space.LARGE),
        Arrangement.spacedBy(Space.MEDIUM),
        Alignment.CenterVertically,
    ) {
        SmallIcon(iconOf(strand.name), colours.onPane, Modifier.clearAndSetSemantics { }, ICON)
        Column(Modifier.weight(1f), Arrangement.spacedBy(Space.HAIR)) {
            Text(strand.title(state.language), Modifier.heading(), TextStyles.pageTitle)
            Text(strand.about(state.language), style = TextStyles.label)
            Text(
                LearningTexts.stepsDone(spoken, done, strand.lessons.size),
                style = TextStyles.compact,
                color = colours.quiet,
            )
        }
    }
}

/** The way to the courses that a pupil was given. */
@Composable
private fun MyCourses(onClick: () -> Unit) = Column(
    Modifier.padding(top = Space.LARGE),
    Arrangement.spacedBy(Space.SMALL),
    Alignment.Start,
) {
    Text(LearningTexts.mapCourses(spoken), style = TextStyles.sentence)
    Button(SchoolTexts.courseList(spoken), LearningTags.MAP_COURSES, ButtonKind.SECOND, onClick = onClick)
}

private val CARD_WIDTH = 200.dp
private val ICON = 40.dp

/** So many cards before the next one stay in sight: a row of a phone. */
private const val CARDS_ABOVE = 2
