package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.ProgramCompiler
import robotran.projects.PENBOT_TARGET
import robotran.projects.RobotProgramSets
import robotran.projects.readRobotLoads
import robotran.robolang.format.FormatResult
import robotran.robolang.format.formatRobolang
import robotran.robolang.messages.RobolangMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class LessonProgramsTest {
    private val tasks = Lessons.all + Lessons.all.map { it.on(BrickKind.NXT) } + worldTasks

    @Test
    fun `programs and solutions in Robolang look as the formatter writes them`() {
        for (lesson in tasks.filter { it.programLanguage == ProgramLanguage.ROBOLANG }) {
            for (file in listOf(lesson.program, lesson.solution)) {
                assertEquals(
                    file.text,
                    assertIs<FormatResult.Success>(
                        formatRobolang(file.text, messages = RobolangMessages.of(Language.ENGLISH)),
                    ).text,
                    lesson.name,
                )
            }
        }
    }

    @Test
    fun `no sentence of a program to begin with goes over two notes`() {
        for (lesson in tasks.filter { it.programLanguage == ProgramLanguage.ROBOLANG }) {
            val split = lesson.program.text.lines().zipWithNext().filter { (one, next) ->
                listOf(one, next).all { it.trim().startsWith("//") }
            }
            assertEquals(emptyList(), split, lesson.name)
        }
    }

    @Test
    fun `no solution gets a warning, nor does what a pupil begins with in a world`() = runTest {
        val compiler = ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH)
        for (lesson in tasks) {
            for (given in lesson.solutions + listOf(lesson.program).filter { lesson in worldTasks }) {
                val ready = readRobotLoads(lesson.project(Language.ENGLISH, listOf(given)), compiler)
                val warnings = assertIs<RobotProgramSets.Success>(ready, lesson.name).warnings
                assertEquals(emptyList(), warnings, "${lesson.name}: ${given.name}")
            }
        }
    }
}
