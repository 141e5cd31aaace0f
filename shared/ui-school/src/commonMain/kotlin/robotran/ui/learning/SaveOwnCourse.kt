package robotran.ui.learning

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.SavedOwnCourse

/** Saves the course [name], which comes with Robotran and is called [title] here, as a file. */
@Composable
internal fun SaveOwnCourse(name: String, title: String, saved: SavedOwnCourse?, onEvent: (WorkshopEvent) -> Unit) =
    Column(verticalArrangement = Arrangement.spacedBy(Space.TINY)) {
        val words = SchoolTexts.courseSaveOwnOf(spoken, title)
        Button(words, LearningTags.courseSave(name), ButtonKind.SECOND) { onEvent(CourseEvent.OwnCourseSaved(name)) }
        if (saved?.name == name) Outcome(saved)
    }

@Composable
private fun Outcome(saved: SavedOwnCourse) {
    val error = saved.error
    val news = Modifier.testTag(LearningTags.courseSaved(saved.name)).announced()
    if (error == null) {
        Explanation(SchoolTexts.handInSaved(spoken, saved.file.orEmpty()), news)
    } else {
        Explanation(SchoolTexts.handInNotSaved(spoken, error).trim(), news, bad = true)
    }
}
