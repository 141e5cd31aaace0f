package robotran.workshop.learning

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.languagesupport.SourceFile
import robotran.learning.Lesson
import robotran.learning.WorldGallery
import robotran.nqc.NqcResult
import robotran.nqc.compileNqc
import robotran.nqc.messages.NqcMessages
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.projects.PENBOT_TARGET
import robotran.projects.RobotProgramSets
import robotran.projects.readRobotLoads
import robotran.simulation.Session
import robotran.simulation.grade.runForGoals
import robotran.simulation.physics.loadPhysicsEngine
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

class NqcVersionsTest {
    private val versions = NqcVersions()
    private val tasks = WorldGallery.worlds.flatMap { listOf(it) + it.harder }.mapNotNull { it.lesson }
        .filter { it.brick == BrickKind.RCX }

    @Test
    fun `programs that NQC cannot do stay in Robolang`() {
        assertEquals(UNTRANSLATED, names { versions.start(it) == null })
        val worlds = names { versions.solution(it) == null && "harder" !in it.name }
        assertEquals(UNTRANSLATED.filter { "harder" !in it }.toSet() + "obstacle-course", worlds)
    }

    @Test
    fun `translated programs have no mistakes and nothing to warn of`() {
        for (task in tasks) {
            for (program in listOfNotNull(versions.start(task), versions.solution(task))) {
                val result =
                    compileNqc(program.name, program.files.single().text, messages = NqcMessages.of(Language.ENGLISH))
                assertEquals(emptyList(), assertIs<NqcResult.Success>(result, task.name).warnings, task.name)
                assertTrue(versions.has(program), task.name)
            }
        }
    }

    @Test
    fun `every translated solution reaches the goals`() = runTest(timeout = 10.minutes) {
        val failed = tasks.flatMap { task ->
            val solution = versions.solution(task) ?: return@flatMap emptyList()
            (1..SEEDS).filterNot { isSolved(task, solution, it) }.map { "${task.name}, seed $it" }
        }
        assertEquals(emptyList(), failed)
    }

    /** The names of tasks without `world/`. */
    private fun names(isMeant: (Lesson) -> Boolean): Set<String> =
        tasks.filter(isMeant).map { it.name.substringAfter('/') }.toSet()

    private suspend fun isSolved(task: Lesson, program: Program, seed: Int): Boolean {
        val files = listOf(SourceFile(program.name, program.files.single().text))
        val project = task.project(Language.ENGLISH, files)
        val loads =
            assertIs<RobotProgramSets.Success>(
                readRobotLoads(project, ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH)),
            )
        val session = Session(project.worldToRun.copy(seed = seed), loads.loads, loadPhysicsEngine(), Language.ENGLISH)
        session.runForGoals()
        return task.attempt(files.single().text, session.state).also { session.close() }.isSolved
    }

    private companion object {
        const val SEEDS = 2

        /** Their programs have something that NQC cannot do, each with its harder variations. */
        val UNTRANSLATED = listOf("thermometer", "line-gaps", "long-way", "remote-message")
            .flatMap { listOf(it, "$it/harder-1", "$it/harder-2") }.toSet()
    }
}
