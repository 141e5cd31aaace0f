package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.ProgramCompiler
import robotran.programs.SourceFile
import robotran.projects.Project
import robotran.projects.RobotLoads
import robotran.projects.readRobotLoads
import robotran.robolang.robot.Calibration
import robotran.simulation.Session
import robotran.simulation.grade.Grade
import robotran.simulation.grade.runForGoals
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.Penbot
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class TutorialTest {
    @Test
    fun `there are ten steps, each with its own name`() {
        assertEquals(10, Tutorial.steps.map { it.name }.toSet().size)
    }

    @Test
    fun `every step's solution reaches the goals and the program that is given does not`() = runTest {
        for (step in Tutorial.steps) {
            val solved = grade(step.project(Language.ENGLISH, listOf(step.solution)))
            assertTrue(solved.passed, "${step.name} is not solved: ${solved.unmet}")
            val given = grade(step.project(Language.ENGLISH))
            assertFalse(given.passed, "${step.name} is solved before anybody has done anything")
        }
    }

    @Test
    fun `every step says as much in every language, each in its own words`() {
        for (step in Tutorial.steps) {
            for (inBlocks in listOf(false, true)) saysAsMuch(step, inBlocks)
        }
    }

    private fun saysAsMuch(step: TutorialStep, inBlocks: Boolean) {
        val said = Language.entries.map { step.text(it, inBlocks) }
        assertEquals(1, said.map { it.paragraphs.size }.toSet().size, step.name)
        assertTrue(said.all { it.paragraphs.size in 2..4 }, step.name)
        assertTrue(said.all { it.title.isNotBlank() && it.task.isNotBlank() && it.hint.isNotBlank() }, step.name)
        assertEquals(said.size, said.map { it.task }.toSet().size, step.name)
        assertTrue(
            said.none {
                '!' in it.task + it.hint + it.paragraphs.joinToString("").replace("!=", "")
            },
            step.name,
        )
    }

    @Test
    fun `program text in the steps is the same in every language`() {
        for (step in Tutorial.steps) {
            for (inBlocks in listOf(false, true)) {
                val quoted = Language.entries.map { language ->
                    step.text(language, inBlocks).run { paragraphs + task + hint }.map(::quoted)
                }
                assertEquals(1, quoted.toSet().size, "${step.name}: $quoted")
            }
        }
    }

    @Test
    fun `whoever works in blocks is told about blocks, and nobody sees the marks of the file`() {
        for (step in Tutorial.steps) {
            val isRobolang = step.code == ProgramLanguage.ROBOLANG
            for (language in Language.entries) {
                val text = step.text(language)
                val blocks = step.text(language, inBlocks = true)
                assertEquals(isRobolang, text.hint != blocks.hint, "${step.name}: the hint")
                assertEquals(text.title to text.task, blocks.title to blocks.task, step.name)
                val all = listOf(text, blocks).flatMap { it.paragraphs + it.task + it.hint }
                assertTrue(all.none { "(text)" in it || "(blocks)" in it || it != it.trim() }, "$all")
            }
        }
    }

    @Test
    fun `what a step quotes from Robolang is known to the help`() {
        val words = Tutorial.steps.filter { it.program.name.endsWith(".robo") }.map { it.program.text }
        assertTrue(words.all { text -> helpOn(Language.SPANISH, ProgramLanguage.ROBOLANG, text, 0) != null })
    }

    @Test
    fun `the world of a step carries its title and task in the pupil's language`() {
        val step = Tutorial.steps.first()
        assertEquals(step.text(Language.GERMAN).title, step.world(Language.GERMAN).title)
        assertNotEquals(step.world(Language.ENGLISH).task, step.world(Language.GERMAN).task)
        assertTrue(Tutorial.steps.none { '`' in it.world(Language.ENGLISH).task })
    }

    @Test
    fun `the pupil's own version of a program takes the place of the one given`() {
        val own = SourceFile("mine.robo", "beep\n")
        val project = Tutorial.steps.first().project(Language.ENGLISH, listOf(own))
        assertEquals(listOf(own), project.robots.single().programs.single().files)
    }

    @Test
    fun `the written tutorial has the same steps in the same order`() {
        val page = robolangPages.getValue("robolang.md").substringAfter("## Tutorial").substringBefore("## Reference")
        val headings = Regex("### [0-9]+\\. (.+)").findAll(page).map { it.groupValues[1] }.toList()
        assertEquals(Tutorial.steps.map { it.text(Language.ENGLISH).title }, headings)
    }

    private fun quoted(text: String): List<String> = text.split('`').filterIndexed { place, _ -> place % 2 == 1 }

    private suspend fun grade(project: Project): Grade {
        val loads = readRobotLoads(project, reader)
        val session =
            Session(project.worldToRun, assertIs<RobotLoads.Ready>(loads, "$loads").loads, loadPhysicsEngine())
        return session.runForGoals().also { session.close() }
    }

    private companion object {
        val reader = ProgramCompiler(Calibration(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE))
    }
}
