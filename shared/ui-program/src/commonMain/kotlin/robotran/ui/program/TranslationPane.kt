package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.Immutable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.alpha
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.editableText
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.language.ShownLanguage
import robotran.languagesupport.CodeTokens
import robotran.programs.ProgramTranslation
import robotran.programs.TranslationNote
import robotran.programs.code
import robotran.textediting.text.TextDocument
import robotran.ui.program.editor.EditorMarks
import robotran.ui.program.editor.EditorPaint
import robotran.ui.program.editor.EditorSurface
import robotran.ui.program.editor.EditorTouch
import robotran.ui.program.editor.EditorView
import robotran.ui.program.editor.listenFor
import robotran.ui.program.editor.listenForZoom
import robotran.ui.program.editor.rememberLineLayouts
import robotran.ui.program.editor.scrolls
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.ui.programlanguages.translationTexts
import robotran.uikit.*

/**
 * A program as another text.
 *
 * @property translation null if there never was one, such as before the first errors are fixed.
 * @property kind what it is, or would be, shown as.
 * @property isNow whether it belongs to the current program.
 * @property highlighted its lines, from 1, that correspond to the line of the caret.
 * @property running its lines, from 1, that correspond to the running line.
 */
@Immutable
internal class ShownTranslation(
    val translation: ProgramTranslation?,
    val kind: ShownLanguage,
    val isNow: Boolean,
    val highlighted: Set<Int>,
    val running: Set<Int>,
) {
    /** Whether pupils can go on with it as with a program of their own. */
    val isProgram: Boolean get() = kind.programs != null
}

/**
 * A program as another text.
 *
 * @param onLine receives the tapped line, from 1.
 * @param onNote receives the tapped note.
 * @param onKeep adds it as a new program, or saves it if nobody programs in it here; null if there is no room.
 */
@Composable
internal fun TranslationPane(
    shown: ShownTranslation,
    codeSize: Float,
    onLine: (Int) -> Unit,
    onNote: (TranslationNote) -> Unit,
    onZoom: (Float) -> Unit,
    onKeep: (() -> Unit)?,
    modifier: Modifier = Modifier,
) {
    val translation = shown.translation
    val isNow = shown.isNow
    val colours = LocalRobotranColours.current
    Column(modifier.background(colours.pane).testTag(ProgramTags.TRANSLATION)) {
        Row(
            Modifier
                .fillMaxWidth()
                .heightIn(min = Dimensions.TARGET)
                .background(colours.desk.copy(alpha = SHADE))
                .padding(start = 16.dp, end = 8.dp),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            val title = when {
                translation == null -> shown.kind.translationTexts.noneYet(spoken)
                isNow -> translation.fileName
                else -> EditorTexts.translationOld(spoken)
            }
            Text(title, Modifier.weight(1f), TextStyles.small, maxLines = 2, overflow = TextOverflow.Ellipsis)
            if (translation != null && isNow && onKeep != null) {
                Button(
                    if (shown.isProgram) EditorTexts.translationKeep(spoken) else EditorTexts.translationSave(spoken),
                    ProgramTags.TRANSLATION_KEEP,
                    ButtonKind.LINK,
                    style = TextStyles.small,
                    onClick = onKeep,
                )
            }
        }
        if (translation != null && isNow) TranslationNotes(translation.notes, onNote)
        Box(Modifier.weight(1f).fillMaxWidth()) {
            val look = Modifier.alpha(if (isNow) 1f else OLD)
            if (translation != null) {
                val marks = remember(isNow, shown.highlighted, shown.running) {
                    if (isNow) {
                        EditorMarks(
                            partners = shown.highlighted,
                            runningPartners = shown.running,
                        )
                    } else {
                        EditorMarks()
                    }
                }
                TranslatedText(translation, marks, codeSize, onLine, onZoom, look)
            }
        }
    }
}

@Composable
private fun TranslatedText(
    translation: ProgramTranslation,
    marks: EditorMarks,
    codeSize: Float,
    onLine: (Int) -> Unit,
    onZoom: (Float) -> Unit,
    modifier: Modifier,
) {
    val label = translation.language.translationTexts.label(spoken)
    val view = remember { EditorView() }
    val draft = remember(translation.text) { TextDocument(translation.text.trimEnd('\n')) }
    val code = translation.language.code
    val brick = remember(draft) { code.brickOf(draft.lines) ?: BrickKind.default }
    val layouts = rememberLineLayouts(code, brick, codeSize)
    val pieces = remember(draft) { CodeTokens(draft.lines, code, brick) }
    val paint = remember(draft, marks) { EditorPaint(draft, marks, hasFocus = false) }
    val line by rememberUpdatedState(onLine)
    val zoom by rememberUpdatedState(onZoom)
    val touch = remember(view) {
        object : EditorTouch {
            override fun tapped(position: Offset, times: Int, selecting: Boolean, byFinger: Boolean) =
                line(view.geometry.lineAt(position.y + view.scrollY) + 1)

            override fun longPressed(position: Offset) = Unit

            override fun draggedTo(position: Offset) = Unit

            override fun zoomed(factor: Float) = zoom(factor)
        }
    }
    // What runs counts more than where the caret is.
    val seen = marks.runningPartners.ifEmpty { marks.partners }
    LaunchedEffect(seen, view.size) {
        withFrameNanos { }
        val inText = seen.filter { it <= view.geometry.lines }
        inText.maxOrNull()?.let { view.scrollTo(it - 1) }
        inText.minOrNull()?.let { view.scrollTo(it - 1) }
    }
    EditorSurface(
        paint,
        pieces,
        view,
        layouts,
        emptyList(),
        modifier
            .fillMaxSize()
            .testTag(ProgramTags.TRANSLATION_TEXT)
            .semantics {
                contentDescription = label
                // A field that cannot be written: the page's screen readers read what is in a field, line by line.
                editableText = AnnotatedString(translation.text)
            }
            .pointerInput(touch) { listenForZoom(touch) }
            .scrolls(view)
            .pointerInput(touch) { listenFor(touch) },
    )
}

private const val SHADE = 0.5f

/** The alpha of an outdated translation. */
private const val OLD = 0.55f
