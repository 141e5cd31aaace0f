package robotran.ui.program

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.dp
import robotran.programs.TranslationNote
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*

/** What is lost or changed in a translation, above it; a tap leads to the line of the program. Empty without notes. */
@Composable
internal fun TranslationNotes(notes: List<TranslationNote>, onNote: (TranslationNote) -> Unit) {
    if (notes.isEmpty()) return
    val scroll = rememberScrollState()
    Column(
        Modifier
            .fillMaxWidth()
            .heightIn(max = MAX_HEIGHT * LocalDensity.current.fontScale.coerceAtMost(MAX_SCALE))
            .testTag(ProgramTags.TRANSLATION_REMARKS)
            .scrollHint(scroll)
            .verticalScroll(scroll),
    ) {
        for (note in notes) {
            Box(
                Modifier
                    .fillMaxWidth()
                    .defaultMinSize(minHeight = Dimensions.TARGET)
                    .focusRing()
                    .clickable(role = Role.Button) { onNote(note) }
                    .padding(horizontal = 16.dp, vertical = 6.dp),
                Alignment.CenterStart,
            ) {
                Text(EditorTexts.mistake(spoken, note.line, note.message), style = TextStyles.smallLines)
            }
        }
    }
    HorizontalDivider()
}

/** Room for two notes and a part of a third. */
private val MAX_HEIGHT = 124.dp
private const val MAX_SCALE = 1.5f
