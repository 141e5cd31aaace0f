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
    fun `no solution gets a warning`() = runTest {
        val compiler = ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH)
        for (lesson in tasks) {
            for (solution in lesson.solutions) {
                val ready = readRobotLoads(lesson.project(Language.ENGLISH, listOf(solution)), compiler)
                assertEquals(emptyList(), assertIs<RobotProgramSets.Success>(ready, lesson.name).warnings, lesson.name)
            }
        }
    }
}
