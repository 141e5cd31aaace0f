package robotran.ui.learning

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.learning.Lessons
import robotran.learning.Strand
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningState
import robotran.workshop.state.SavedOwnCourse

/** All strands, each a path with its lessons as stations: which are done, which is next. A touch opens a lesson. */
@Composable
internal fun LessonMapPage(state: LearningState, saved: SavedOwnCourse?, onEvent: (WorkshopEvent) -> Unit) {
    val strands = rememberLazyListState(
        state.nextLesson?.let { next ->
            Lessons.strands.indexOf(Lessons.strandOf(Lessons.all[next]))
        } ?: 0,
    )
    Page(LearningTexts.map(spoken), LearningTags.MAP_PAGE, {
        onEvent(LearningEvent.PageClosed)
    }, strands, maxWidth = 960.dp) {
        LazyColumn(
            Modifier.fillMaxSize().testTag(LearningTags.MAP).scrolledByReaders(strands) {
                strands.layoutInfo.viewportSize.height
            },
            strands,
            PaddingValues(20.dp),
            verticalArrangement = Arrangement.spacedBy(32.dp),
        ) {
            items(Lessons.strands, key = { it.name }) { strand ->
                StrandOnMap(strand, state, saved, onEvent)
            }
        }
    }
}

@Composable
private fun StrandOnMap(
    strand: Strand,
    state: LearningState,
    saved: SavedOwnCourse?,
    onEvent: (WorkshopEvent) -> Unit,
) {
    val colours = LocalRobotranColours.current
    val done = strand.lessons.count { it.name in state.stepsDone }
    Column(Modifier.testTag(LearningTags.strand(strand.name)), Arrangement.spacedBy(4.dp)) {
        Text(strand.title(state.language), Modifier.heading(), TextStyles.pageTitle)
        Text(strand.about(state.language), style = TextStyles.label)
        Text(
            LearningTexts.stepsDone(spoken, done, strand.lessons.size),
            style = TextStyles.compact,
            color = colours.quiet,
        )
        StationPath(
            strand.lessons.map { lesson ->
                val index = Lessons.all.indexOf(lesson)
                val isDone = lesson.name in state.stepsDone
                Stop(
                    LearningTags.lesson(lesson.name),
                    lesson.text(state.language).title,
                    isDone,
                    state.nextLesson == index,
                ) {
                    onEvent(LearningEvent.LessonChosen(index))
                }
            },
        )
        SaveOwnCourse(strand.name, strand.title(state.language), saved, onEvent)
    }
}
