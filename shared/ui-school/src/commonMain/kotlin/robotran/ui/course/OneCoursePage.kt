package robotran.ui.course

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.ui.learning.MarkedText
import robotran.ui.learning.StationPath
import robotran.ui.learning.Stop
import robotran.ui.school.tags.CourseTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.CoursePage
import robotran.workshop.state.CourseTask

/** A course: what it is about, and the path of its assignments. A touch begins one or goes on with it. */
@Composable
internal fun OneCoursePage(page: CoursePage.OneCourse, onEvent: (WorkshopEvent) -> Unit) {
    val next = page.next
    val scroll = rememberScrollState()
    Page(page.title, CourseTags.COURSE_PAGE, { onEvent(CourseEvent.PageClosed) }, scroll, maxWidth = 960.dp) {
        Column(
            Modifier.fillMaxWidth().testTag(CourseTags.COURSE).verticalScroll(scroll).padding(20.dp),
            Arrangement.spacedBy(12.dp),
        ) {
            for (paragraph in page.text.split(PARAGRAPH).filter { it.isNotBlank() }) {
                MarkedText(paragraph.trim(), Modifier.widthIn(max = TEXT_WIDTH))
            }
            Text(
                SchoolTexts.courseDone(spoken, page.done, page.tasks.size),
                Modifier.testTag(CourseTags.COURSE_DONE),
                TextStyles.compact,
                color = LocalRobotranColours.current.quiet,
            )
            if (next == null) {
                Explanation(SchoolTexts.courseAllDone(spoken), Modifier.testTag(CourseTags.COURSE_ALL_DONE))
            } else {
                val words = if (page.tasks.none { it.isBegun }) SchoolTexts::courseBegin else SchoolTexts::courseGoOn
                Button(words(spoken, page.tasks[next].title), CourseTags.COURSE_GO_ON) {
                    onEvent(CourseEvent.TaskChosen(next))
                }
            }
            StationPath(
                page.tasks.mapIndexed { index, task ->
                    Stop(CourseTags.task(index), task.title, task.isDone, index == next, noteOf(task)) {
                        onEvent(CourseEvent.TaskChosen(index))
                    }
                },
            )
            if (page.canBeChanged) TeachersButtons(page, onEvent)
        }
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun TeachersButtons(page: CoursePage.OneCourse, onEvent: (WorkshopEvent) -> Unit) =
    FlowRow(Modifier, Arrangement.spacedBy(8.dp), Arrangement.spacedBy(8.dp)) {
        Button(SchoolTexts.handInsMenu(spoken), CourseTags.COURSE_HAND_INS, ButtonKind.SECOND) {
            onEvent(CourseEvent.HandInsRequested(page.key))
        }
        Button(SchoolTexts.courseChange(spoken), CourseTags.COURSE_CHANGE, ButtonKind.SECOND) {
            onEvent(CourseEvent.MakingRequested(page.key))
        }
    }

@Composable
private fun noteOf(task: CourseTask): String? {
    val best = task.best
    return when {
        task.isDone -> null
        best != null && best.goals > 0 -> SchoolTexts.courseTaskBest(spoken, best.goalsMet, best.goals)
        task.isBegun -> SchoolTexts.courseTaskBegun(spoken)
        else -> null
    }
}

private val PARAGRAPH = Regex("\\n\\s*\\n")
private val TEXT_WIDTH = 720.dp
