package robotran.ui.program.editor

import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.test.ExperimentalTestApi
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.languagesupport.CodeTokens
import robotran.learning.Lesson
import robotran.learning.Lessons
import robotran.programs.support
import robotran.textediting.text.TextDocument
import robotran.ui.screen.pass
import robotran.ui.screen.undrawnTest
import robotran.ui.theme.RobotranTheme
import robotran.uikit.*
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** In a lesson on a small laptop the text editor is 400 dp wide. */
@OptIn(ExperimentalTestApi::class)
class LessonProgramsFitTest {
    @Test
    fun `each line of a lesson's program, and of its solution, is wholly in sight`() = undrawnTest(400, 700) {
        mainClock.autoAdvance = false
        val lessons = Lessons.all.flatMap { lesson -> BrickKind.entries.map(lesson::on) }
        var shown by mutableStateOf(ShownLesson(lessons.first(), inSolution = false))
        setContent { RobotranTheme(dark = false) { shown.Editor() } }
        var broken = 0
        for (lesson in lessons) {
            for (inSolution in listOf(false, true)) {
                shown = ShownLesson(lesson, inSolution)
                pass(32)
                val rows = shown.rowsOfEachLine()
                assertEquals(emptyList(), rows.flatten().filter { it > 400f }, "${lesson.name} $inSolution")
                broken += rows.count { it.size > 1 }
            }
        }
        assertTrue(broken > 20, "lines in several rows: $broken")
    }

    private class ShownLesson(lesson: Lesson, inSolution: Boolean) {
        private val file = if (inSolution) lesson.solution else lesson.program
        private val language = ProgramLanguage.ofFileOrDefault(file.name)
        private val draft = TextDocument(file.text.trimEnd())
        private val view = EditorView()
        private val brick = lesson.brick
        private val pieces = CodeTokens(draft.lines, language.support.code, brick)
        private lateinit var layouts: LineLayouts

        @Composable
        fun Editor() {
            layouts = rememberLineLayouts(language.support.code, brick, Dimensions.CODE_SIZE.value)
            val paint = remember(draft) { EditorPaint(draft, EditorMarks(), hasFocus = false) }
            EditorSurface(paint, pieces, view, layouts, emptyList(), Modifier.fillMaxSize())
        }

        /** Where each row of each line ends, in pixels from the left edge of the pane. Blanks at its end do not count. */
        fun rowsOfEachLine(): List<List<Float>> = (0..<draft.lines.count).map { line ->
            val laidOut = view.laidOut(line, draft, layouts, pieces)
            (0..<laidOut.rows.count).map { row ->
                val text = laidOut.layout(row).layoutInput.text.text.trimEnd()
                val end = laidOut.layout(row).getHorizontalPosition(text.length, usePrimaryDirection = true)
                view.gutter + laidOut.left(row) + end
            }
        }
    }
}
