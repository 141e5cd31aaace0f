package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.language.ProgramLanguage
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramDiagnostic
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.programs.SourceFile
import robotran.projects.PENBOT_TARGET
import robotran.robolang.format.FormatResult
import robotran.robolang.format.formatRobolang
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class LessonProgramsTest {
    @Test
    fun `programs and solutions in Robolang look as the formatter writes them`() {
        for (lesson in (Lessons.all + worldTasks).filter { it.code == ProgramLanguage.ROBOLANG }) {
            for (file in listOf(lesson.program, lesson.solution)) {
                assertEquals(file.text, assertIs<FormatResult.Formatted>(formatRobolang(file.text)).text, lesson.name)
            }
        }
    }

    @Test
    fun `no solution gets a warning`() = runTest {
        val compiler = ProgramCompiler(PENBOT_TARGET)
        for (lesson in Lessons.all + worldTasks) {
            val ready = assertIs<ProgramResult.Ready>(compiler.read(sourceOf(lesson, lesson.solution)), lesson.name)
            assertEquals(emptyList<ProgramDiagnostic>(), ready.warnings, lesson.name)
        }
    }

    private fun sourceOf(lesson: Lesson, file: SourceFile): ProgramSource = when (lesson.code) {
        ProgramLanguage.ROBOLANG -> ProgramSource.Robolang(file.name, file.text)
        ProgramLanguage.JAVA -> ProgramSource.Java(file.name, listOf(file))
    }
}
