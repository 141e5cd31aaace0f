package robotran.ui.robot

import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.hasAnyAncestor
import androidx.compose.ui.test.hasTestTag
import androidx.compose.ui.text.TextLayoutResult
import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotItem
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pass
import robotran.ui.world.tags.WorldTags
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.Settings
import robotran.world.ReadyRobots
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The words of the workbench's palette can be read in each language, also with the largest text. */
@OptIn(ExperimentalTestApi::class)
class RobotPaletteTest {
    @Test
    fun `no word is cut off or broken without a hyphen`() = inEachLanguage { words ->
        for (word in words) {
            val text = word.layoutInput.text.text
            assertTrue(!word.didOverflowHeight && word.getLineEnd(word.lineCount - 1) == text.length, text)
            val ends = (0..<word.lineCount - 1).map { word.getLineEnd(it) }
            val broken = ends.filter { text[it - 1].isLetterOrDigit() && text[it].isLetterOrDigit() }
            assertEquals(emptyList(), broken, text)
        }
    }

    @Test
    fun `no two parts are called alike`() = inEachLanguage { words ->
        val texts = words.map { it.layoutInput.text.text }
        assertEquals(RobotItem.of(BrickKind.NXT).size, texts.toSet().size, "$texts")
    }

    private fun inEachLanguage(check: (List<TextLayoutResult>) -> Unit) {
        for (language in Language.entries) {
            for ((scale, width, height) in listOf(Triple(1f, 1180, 820), Triple(2f, 390, 844))) {
                val workshop = runBlocking { openWorkshop() }
                workshop.handle(SettingsEvent.SettingsChanged(Settings(textScale = scale, language = language)))
                onScreenOf(workshop, width, height) {
                    workshop.handle(RobotEditEvent.BenchOpened())
                    workshop.handle(RobotEditEvent.Edited(RobotEdit.Replace(ReadyRobots.NXT_PENBOT)))
                    pass(300)
                    check(wordsOfPalette())
                }
            }
        }
    }

    private fun ComposeUiTest.wordsOfPalette(): List<TextLayoutResult> {
        val isWord = SemanticsMatcher.keyIsDefined(SemanticsActions.GetTextLayoutResult)
        val words = onAllNodes(isWord and hasAnyAncestor(hasTestTag(WorldTags.ROBOT_PALETTE)), useUnmergedTree = true)
        return words.fetchSemanticsNodes().flatMap { node ->
            buildList { node.config.getOrNull(SemanticsActions.GetTextLayoutResult)?.action?.invoke(this) }
        }
    }
}
