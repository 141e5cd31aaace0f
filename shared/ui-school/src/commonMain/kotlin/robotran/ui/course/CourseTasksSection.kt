package robotran.ui.course

import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.assignments.course.assignmentId
import robotran.projects.Project
import robotran.ui.assignment.Quiet
import robotran.ui.assignment.making.Chips
import robotran.ui.assignment.making.ComesIntoView
import robotran.ui.assignment.making.Section
import robotran.ui.school.tags.CourseTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.CoursePage
import robotran.workshop.state.WorkToAdd

/** The assignments of a course in their order, and where to get more. */
@Composable
internal fun CourseTasksSection(page: CoursePage.Making, onEvent: (WorkshopEvent) -> Unit) {
    val tasks = page.course.assignments
    Section(SchoolTexts.courseTasks(spoken), CourseTags.COURSE_TASKS) {
        if (tasks.isEmpty()) {
            Explanation(
                SchoolTexts.courseTasksNone(spoken),
                Modifier.testTag(CourseTags.COURSE_TASKS_NONE),
            )
        }
        tasks.forEachIndexed { index, task ->
            // The focus goes with a row that moves.
            key(task.assignmentId) { TaskRow(task, index, tasks.size, onEvent) }
        }
        ComesIntoView(page.problem) { page.problem?.let { CourseErrorText(it) } }
        Chips {
            Button(SchoolTexts.courseAddFiles(spoken), CourseTags.COURSE_ADD_FILES, ButtonKind.SECOND) {
                onEvent(CourseEvent.FilesRequested)
            }
            if (page.works == null) {
                Button(SchoolTexts.courseAddWorks(spoken), CourseTags.COURSE_ADD_WORKS, ButtonKind.SECOND) {
                    onEvent(CourseEvent.WorksShown(true))
                }
            }
            Button(SchoolTexts.makeUndo(spoken), CourseTags.COURSE_UNDO, ButtonKind.QUIET, enabled = page.canUndo) {
                onEvent(CourseEvent.UndoRequested)
            }
        }
        page.works?.let { Works(it, onEvent) }
        Quiet(SchoolTexts.courseTasksHelp(spoken), CourseTags.COURSE_TASKS_HELP)
    }
}

@Composable
private fun TaskRow(task: Project, index: Int, count: Int, onEvent: (WorkshopEvent) -> Unit) {
    val title = task.world.title
    Surface(Modifier.fillMaxWidth().testTag(CourseTags.row(index))) {
        BoxWithConstraints(Modifier.padding(start = 16.dp, end = 4.dp)) {
            // A title beside the buttons needs room for some words.
            val isBroad = maxWidth >= BROAD * LocalDensity.current.fontScale
            val words = @Composable { modifier: Modifier ->
                Text("${index + 1}  $title", modifier.padding(vertical = 12.dp), TextStyles.sentence)
            }
            if (isBroad) {
                Row(verticalAlignment = Alignment.CenterVertically) {
                    words(Modifier.weight(1f))
                    TaskButtons(title, index, count, onEvent)
                }
            } else {
                Column {
                    words(Modifier)
                    TaskButtons(title, index, count, onEvent)
                }
            }
        }
    }
}

@Composable
private fun TaskButtons(title: String, index: Int, count: Int, onEvent: (WorkshopEvent) -> Unit) = Row {
    IconButton(
        ThinIcons.UP,
        SchoolTexts.courseUp(spoken, title),
        CourseTags.up(index),
        IconButtonKind.SMALL,
        enabled = index > 0,
    ) { onEvent(CourseEvent.TaskMoved(index, -1)) }
    IconButton(
        ThinIcons.DOWN,
        SchoolTexts.courseDown(spoken, title),
        CourseTags.down(index),
        IconButtonKind.SMALL,
        enabled = index < count - 1,
    ) { onEvent(CourseEvent.TaskMoved(index, 1)) }
    IconButton(Icon.SHEET_EDIT, SchoolTexts.courseEdit(spoken, title), CourseTags.edit(index)) {
        onEvent(CourseEvent.TaskOpened(index))
    }
    IconButton(
        ThinIcons.CROSS,
        SchoolTexts.courseTakeOut(spoken, title),
        CourseTags.takeOut(index),
        IconButtonKind.SMALL,
    ) {
        onEvent(CourseEvent.TaskRemoved(index))
    }
}

@Composable
private fun Works(works: List<WorkToAdd>, onEvent: (WorkshopEvent) -> Unit) {
    Column(Modifier.testTag(CourseTags.COURSE_WORKS)) {
        if (works.isEmpty()) {
            Explanation(
                SchoolTexts.courseWorksNone(spoken),
                Modifier.testTag(CourseTags.COURSE_WORKS_NONE),
            )
        }
        Chips {
            for (work in works) {
                val name = if (work.name == work.title) work.name else "${work.title} (${work.name})"
                Button(SchoolTexts.courseAdd(spoken, name), CourseTags.work(work.id), ButtonKind.SECOND) {
                    onEvent(CourseEvent.WorkAdded(work.id))
                }
            }
        }
        Button(SchoolTexts.courseWorksClose(spoken), CourseTags.COURSE_WORKS_CLOSE, ButtonKind.QUIET) {
            onEvent(CourseEvent.WorksShown(false))
        }
    }
}

private val BROAD = 440.dp
