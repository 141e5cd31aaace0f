package robotran.ui.learning

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.text.TextLayoutResult
import androidx.compose.ui.unit.dp
import robotran.language.Language
import robotran.learning.Lessons
import robotran.ui.screen.pass
import robotran.ui.screen.undrawnTest
import robotran.ui.theme.RobotranTheme
import kotlin.test.Test
import kotlin.test.assertEquals

@OptIn(ExperimentalTestApi::class)
class MarkedTextTest {
    @Test
    fun `code in a sentence is not broken within a word, however wide the sentence is`() = undrawnTest(700, 900) {
        mainClock.autoAdvance = false
        val sentences = Lessons.all.filter { it.strand in listOf("decide", "java") }.flatMap { lesson ->
            Language.entries.flatMap { lesson.text(it).run { paragraphs + task + solution } }
        }.filter { '`' in it }
        var width by mutableIntStateOf(240)
        setContent {
            RobotranTheme(dark = false) {
                Column { for (sentence in sentences) MarkedText(sentence, Modifier.width(width.dp)) }
            }
        }
        for (next in 240..640 step 9) {
            width = next
            pass(20)
            assertEquals(emptyList(), brokenWords(), "at $next")
        }
    }

    private fun ComposeUiTest.brokenWords(): List<String> {
        val hasText = SemanticsMatcher.keyIsDefined(SemanticsActions.GetTextLayoutResult)
        return onAllNodes(hasText, useUnmergedTree = true).fetchSemanticsNodes().flatMap { node ->
            val layouts = mutableListOf<TextLayoutResult>()
            node.config.getOrNull(SemanticsActions.GetTextLayoutResult)?.action?.invoke(layouts)
            layouts.flatMap { it.brokenWords() }
        }
    }

    private fun TextLayoutResult.brokenWords(): List<String> {
        val text = layoutInput.text.text
        return (0..<lineCount - 1).map { getLineEnd(it) }
            .filter { it in 1..<text.length && text[it - 1].isLetterOrDigit() && text[it].isLetterOrDigit() }
            .map { text.substring(0, it).takeLast(CONTEXT) + "/" + text.substring(it).take(CONTEXT) }
    }

    private companion object {
        const val CONTEXT = 12
    }
}
