package robotran.ui.assignment.making

import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.language.grouped
import robotran.projects.Assignment
import robotran.projects.AssignmentLimits
import robotran.ui.assignment.AssignmentText
import robotran.ui.assignment.Quiet
import robotran.ui.learning.MarkedText
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.AssignmentEditorState
import robotran.workshop.state.PictureError
import robotran.world.WorldLimits

/** What to do: title, task, text and pictures, and how pupils read it. */
@Composable
internal fun TaskSection(state: AssignmentEditorState, change: (Assignment) -> Unit, onEvent: (WorkshopEvent) -> Unit) {
    val assignment = state.assignment
    Section(SchoolTexts.makeTask(spoken), AssignmentTags.MAKE_TASK_SECTION) {
        Field(
            state.title,
            SchoolTexts.makeWorldTitle(spoken),
            AssignmentTags.MAKE_TITLE,
            WorldLimits.MAXIMUM_TITLE_CHARACTERS,
        ) { onEvent(AssignmentEvent.TaskChanged(it, state.task)) }
        if (state.title.isBlank()) Explanation(SchoolTexts.makeTitleEmpty(spoken), bad = true)
        Field(
            state.task,
            SchoolTexts.makeWorldTask(spoken),
            AssignmentTags.MAKE_TASK,
            WorldLimits.MAXIMUM_TASK_CHARACTERS,
            lines = 2,
        ) { onEvent(AssignmentEvent.TaskChanged(state.title, it)) }
        Field(
            assignment.text,
            SchoolTexts.makeText(spoken),
            AssignmentTags.MAKE_TEXT,
            AssignmentLimits.MAXIMUM_TEXT_CHARACTERS,
            lines = 4,
        ) { change(assignment.copy(text = it)) }
        Quiet(SchoolTexts.makeTextHelp(spoken), AssignmentTags.MAKE_TEXT_HELP)
        Pictures(state, change, onEvent)
        if (assignment.text.isNotBlank()) Preview(state)
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Pictures(state: AssignmentEditorState, change: (Assignment) -> Unit, onEvent: (WorkshopEvent) -> Unit) {
    val assignment = state.assignment
    state.pictureError?.let { error ->
        Explanation(
            error.sentence(spoken),
            Modifier.testTag(AssignmentTags.MAKE_PICTURE_ERROR).announced(),
            bad = true,
        )
    }
    state.pictureMadeSmaller?.let { (width, height) ->
        val language = LocalLanguage.current
        Explanation(
            SchoolTexts.makePictureSmaller(spoken, language.grouped(width), language.grouped(height)),
            Modifier.testTag(AssignmentTags.MAKE_PICTURE_SMALLER).announced(),
        )
    }
    FlowRow(Modifier, Arrangement.spacedBy(8.dp), Arrangement.spacedBy(8.dp)) {
        Button(SchoolTexts.makePicture(spoken), AssignmentTags.MAKE_PICTURE, ButtonKind.SECOND) {
            onEvent(AssignmentEvent.PictureRequested)
        }
        assignment.pictures.forEachIndexed { index, picture ->
            Button(
                SchoolTexts.makePictureRemove(spoken, picture.name),
                AssignmentTags.makePictureRemove(index),
                ButtonKind.QUIET,
            ) {
                val marks = assignment.text.lines().filterNot { it.trim().endsWith("](${picture.name})") }
                change(assignment.copy(pictures = assignment.pictures - picture, text = marks.joinToString("\n")))
            }
        }
    }
}

@Composable
private fun Preview(state: AssignmentEditorState) {
    Subtitle(SchoolTexts.makePreview(spoken))
    Column(
        Modifier
            .fillMaxWidth()
            .testTag(AssignmentTags.MAKE_PREVIEW)
            .border(1.dp, LocalRobotranColours.current.line, Shapes.MEDIUM)
            .padding(12.dp),
        Arrangement.spacedBy(8.dp),
    ) {
        if (state.task.isNotBlank()) MarkedText(state.task)
        AssignmentText(state.assignment)
    }
}

private val PictureError.sentence: Label
    get() = when (this) {
        PictureError.TOO_LARGE -> SchoolTexts::makePictureLarge
        PictureError.NOT_A_PICTURE -> SchoolTexts::makePictureNone
        PictureError.TOO_MANY -> SchoolTexts::makePictureMany
        PictureError.HEIC -> SchoolTexts::makePictureHeic
    }
