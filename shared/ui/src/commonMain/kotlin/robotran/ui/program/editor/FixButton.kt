package robotran.ui.program.editor

import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.material3.Text
import androidx.compose.material3.TextButton
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import org.jetbrains.compose.resources.stringResource
import robotran.language.source.Diagnostic
import robotran.ui.resources.*
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.TextSizes
import robotran.ui.theme.focusRing

/**
 * The button that applies the fix of [diagnostic], with a description of the change.
 *
 * @param line the text of the line to change.
 */
@Composable
internal fun FixButton(diagnostic: Diagnostic, line: String, onFix: (Diagnostic) -> Unit) {
    val fix = diagnostic.fix ?: return
    TextButton(
        onClick = { onFix(diagnostic) },
        modifier = Modifier.defaultMinSize(minHeight = Dimensions.TARGET).testTag("fix").focusRing(),
    ) {
        Text(
            textOf(fixLabelOf(diagnostic, fix, line)),
            color = LocalRobotranColours.current.focus,
            fontSize = TextSizes.COMPACT,
            fontWeight = FontWeight.SemiBold,
            maxLines = 2,
            overflow = TextOverflow.Ellipsis,
        )
    }
}

@Composable
private fun textOf(label: FixLabel): String = when (label) {
    is FixLabel.Add -> stringResource(Res.string.mistake_fix_add, label.words)
    is FixLabel.Change -> stringResource(Res.string.mistake_fix, label.words)

    is FixLabel.Remove -> {
        val words = label.words
        if (words.isEmpty()) {
            stringResource(Res.string.mistake_fix_remove)
        } else {
            stringResource(Res.string.mistake_fix_remove_words, words)
        }
    }

    is FixLabel.Space -> stringResource(Res.string.mistake_fix_space, label.mended)
    FixLabel.NormalSpaces -> stringResource(Res.string.mistake_fix_normal_spaces)
    FixLabel.NewLine -> stringResource(Res.string.mistake_fix_new_line)
}
