package robotran.ui.handins

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.input.TextFieldValue
import robotran.projects.AssignmentLimits
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInRow

/** What the teacher writes to the pupil. */
@Composable
internal fun CommentField(row: HandInRow, onEvent: (HandInsEvent) -> Unit) {
    // The field keeps its caret while the state follows.
    var text by remember(row.id) { mutableStateOf(TextFieldValue(row.comment)) }
    TextField(
        text,
        { changed ->
            if (changed.text.length > AssignmentLimits.MAXIMUM_TEXT_CHARACTERS) return@TextField
            if (changed.text != text.text) onEvent(HandInsEvent.CommentChanged(row.id, changed.text))
            text = changed
        },
        Modifier.fillMaxWidth().tabLeaves().testTag(HandInTags.HAND_IN_COMMENT),
        SchoolTexts.handInComment(spoken, row.name),
        MIN_LINES..Int.MAX_VALUE,
        extras = FieldExtras(shape = Shapes.MEDIUM) {
            Text(SchoolTexts.handInCommentHelp(spoken), style = TextStyles.small)
        },
    )
}

private const val MIN_LINES = 3
