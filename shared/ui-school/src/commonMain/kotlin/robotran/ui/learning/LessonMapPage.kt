package robotran.ui.learning

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.grid.LazyGridState
import androidx.compose.foundation.lazy.grid.itemsIndexed
import androidx.compose.foundation.lazy.grid.rememberLazyGridState
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.dp
import kotlinx.coroutines.flow.first
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
    val cards = rememberLazyGridState(headOf(state))
    ShowsNext(state, cards)
    Page(LearningTexts.map(spoken), LearningTags.MAP_PAGE, {
        onEvent(LearningEvent.PageClosed)
    }, cards, maxWidth = 1280.dp) {
        val jump = rememberStrandJump(cards)
        StrandRow(state, jump::to)
        CardGrid(pictureCardColumns(CARD_WIDTH, NARROW_CARD), cards, LearningTags.MAP) {
            wholeRow("where") { WhereOne(state) }
            for (strand in Lessons.strands) {
                wholeRow(strand.name) { StrandHead(strand, state) }
                itemsIndexed(strand.lessons, { _, lesson -> lesson.name }) { place, lesson ->
                    val index = Lessons.indexOf(lesson)
                    val first = if (place == 0) Modifier.focusRequester(jump.firstOf(strand)) else Modifier
                    LessonCard(lesson, place + 1, state, isNext = state.nextLesson == index, first) {
                        onEvent(LearningEvent.LessonChosen(index))
                    }
                }
            }
            wholeRow("courses") { MyCourses { onEvent(CourseEvent.ListRequested) } }
        }
    }
}

/** The element of the grid that is the head of the strand with the next lesson; the first one begins with the page. */
private fun headOf(state: LearningState): Int {
    val next = Lessons.all.getOrNull(state.nextLesson ?: 0) ?: return 0
    return if (next.strand == Lessons.strands.first().name) 0 else headOf(next.strand)
}

/** The element of the grid that is the head of the strand called [name]. */
internal fun headOf(name: String): Int = 1 + Lessons.strands.takeWhile { it.name != name }.sumOf { 1 + it.lessons.size }

/** Where the head of its strand leaves no room for the next lesson, [cards] begin with the row above that, or with it. */
@Composable
private fun ShowsNext(state: LearningState, cards: LazyGridState) = LaunchedEffect(cards) {
    val next = Lessons.all[state.nextLesson ?: return@LaunchedEffect]
    val shown = snapshotFlow { cards.layoutInfo }.first { it.visibleItemsInfo.isNotEmpty() }
    val columns = 1 + shown.visibleItemsInfo.maxOf { it.column }
    val place = Lessons.strandOf(next).lessons.indexOf(next)
    val first = 2 + Lessons.strands.takeWhile { it.name != next.strand }.sumOf { 1 + it.lessons.size }
    for (above in listOf(columns, 0)) {
        if (cards.showsWhole(next.name)) return@LaunchedEffect
        cards.scrollToItem(first + (place - above).coerceAtLeast(0))
    }
}

private fun LazyGridState.showsWhole(key: String): Boolean =
    layoutInfo.visibleItemsInfo.any { it.key == key && it.offset.y + it.size.height <= layoutInfo.viewportEndOffset }

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

private val CARD_WIDTH = 216.dp

/** Two beside each other on a phone. */
private val NARROW_CARD = 140.dp
private val ICON = 40.dp
