package robotran.ui.program.editor

import androidx.compose.runtime.Composable
import androidx.compose.ui.text.style.TextOverflow
import robotran.language.source.Diagnostic
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*

/**
 * The button that applies the fix of [diagnostic], with a description of the change.
 *
 * @param line the text of the line to change.
 */
@Composable
internal fun FixButton(diagnostic: Diagnostic, line: String, onFix: (Diagnostic) -> Unit) {
    val fix = diagnostic.fix ?: return
    ButtonFrame(ProgramTags.FIX, ButtonKind.LINK, onClick = { onFix(diagnostic) }) {
        val words = textOf(fixLabelOf(diagnostic, fix, line))
        Text(words, style = TextStyles.compact.strong, maxLines = 2, overflow = TextOverflow.Ellipsis)
    }
}

@Composable
private fun textOf(label: FixLabel): String = when (label) {
    is FixLabel.Add -> EditorTexts.mistakeFixAdd(spoken, label.words)
    is FixLabel.Change -> EditorTexts.mistakeFix(spoken, label.words)

    is FixLabel.Remove -> {
        val words = label.words
        if (words.isEmpty()) {
            EditorTexts.mistakeFixRemove(spoken)
        } else {
            EditorTexts.mistakeFixRemoveWords(spoken, words)
        }
    }

    is FixLabel.Space -> EditorTexts.mistakeFixSpace(spoken, label.mended)
    FixLabel.NormalSpaces -> EditorTexts.mistakeFixNormalSpaces(spoken)
    FixLabel.NewLine -> EditorTexts.mistakeFixNewLine(spoken)
}
