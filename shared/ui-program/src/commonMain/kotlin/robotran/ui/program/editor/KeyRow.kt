package robotran.ui.program.editor

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.rememberScrollState
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import robotran.programs.support
import robotran.textediting.CaretMove
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*

/** The characters on the second page of on-screen keyboards, for touch typing. */
@Composable
internal fun KeyRow(control: EditorControl) {
    Row(
        Modifier
            .fillMaxWidth()
            .testTag(ProgramTags.KEYS)
            .background(LocalRobotranColours.current.desk)
            .horizontalScroll(rememberScrollState()),
    ) {
        TouchKey("→", EditorTexts.indent(spoken)) { control.perform(EditorCommand.Plain.INDENT) }
        TouchKey("◂", EditorTexts.caretLeft(spoken)) {
            control.perform(EditorCommand.Move(CaretMove.LEFT, selecting = false))
        }
        TouchKey("▸", EditorTexts.caretRight(spoken)) {
            control.perform(EditorCommand.Move(CaretMove.RIGHT, selecting = false))
        }
        for (sign in control.language.support.code.keys) TouchKey(sign, sign) { control.type(sign) }
    }
}

@Composable
private fun TouchKey(sign: String, label: String, onClick: () -> Unit) {
    Box(
        Modifier
            .defaultMinSize(Dimensions.TARGET, Dimensions.TARGET)
            .testTag(ProgramTags.key(sign))
            .focusProperties { canFocus = false }
            .clickable(role = Role.Button, onClick = onClick)
            .named(label),
        Alignment.Center,
    ) {
        Text(sign, style = editorStyle(SIZE))
    }
}

private const val SIZE = 18f
