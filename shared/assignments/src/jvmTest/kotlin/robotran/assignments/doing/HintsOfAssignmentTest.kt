package robotran.assignments.doing

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.hint.HintCondition
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.projects.Assignment
import robotran.projects.AssignmentHint
import robotran.projects.PENBOT_TARGET
import robotran.projects.RobotProgramSets
import robotran.projects.readRobotLoads
import robotran.simulation.Session
import robotran.simulation.grade.runForGoals
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull

class HintsOfAssignmentTest {
    private val world = BuiltInWorlds.plain.copy(goals = listOf(Goal(GoalCondition.InkLength(30.0, null))))

    private fun hintsAfter(program: String, tries: Int, vararg hints: AssignmentHint): List<String> = runBlocking {
        val compiler = ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH)
        val sources = mapOf(world.robots.first().name to listOf(Program("a.robo", ProgramLanguage.ROBOLANG, program)))
        val loads = assertIs<RobotProgramSets.Success>(readRobotLoads(world, compiler, sources)).loads
        val session = Session(world, loads, loadPhysicsEngine(), Language.ENGLISH)
        session.runForGoals()
        val state = session.state
        session.close()
        HintsOfAssignment(Assignment("x", hints = hints.toList()), world).after(program, "beep\n", state, tries)
            .map { it.text }
    }

    @Test
    fun `the first hint that fits is given, and nothing else`() {
        val hints = arrayOf(
            AssignmentHint("moves", "never moved"),
            AssignmentHint("pen", "pen never down"),
            AssignmentHint("short", "too short"),
            AssignmentHint("always"),
        )
        assertEquals(listOf("moves"), hintsAfter("beep\n", 1, *hints))
        assertEquals(listOf("pen"), hintsAfter("forward 5\n", 1, *hints))
        assertEquals(listOf("short"), hintsAfter("pen down\nforward 5\n", 1, *hints))
        assertEquals(listOf("always"), hintsAfter("var zero = 0\nshow 5 / zero\n", 1, *hints.drop(3).toTypedArray()))
    }

    @Test
    fun `hints wait for their number of tries, also those with a condition`() {
        val hints =
            arrayOf(AssignmentHint("late", "never moved", 3), AssignmentHint("two", null, 2), AssignmentHint("one"))
        assertEquals(listOf("one"), hintsAfter("buzz\n", 1, *hints))
        assertEquals(listOf("two", "one"), hintsAfter("buzz\n", 2, *hints))
        assertEquals(listOf("late"), hintsAfter("buzz\n", 3, *hints))
    }

    @Test
    fun `conditions about words tell the word, and an unchanged program is told`() {
        assertEquals(
            listOf("Use repeat."),
            hintsAfter("buzz\n", 1, AssignmentHint("Use {word}.", "word missing: repeat")),
        )
        assertEquals(emptyList(), hintsAfter("buzz\n", 1, AssignmentHint("No.", "word used: repeat")))
        assertEquals(listOf("Same."), hintsAfter("beep\n", 1, AssignmentHint("Same.", "nothing changed")))
    }

    @Test
    fun `every condition of the menu is known`() {
        for (phrase in HintsOfAssignment.conditions) assertNotNull(HintCondition.of(phrase), phrase)
        for (phrase in HintsOfAssignment.wordConditions) assertNotNull(HintCondition.of("$phrase: beep"), phrase)
    }

    @Test
    fun `a condition from a newer version gives no hint`() {
        assertEquals(emptyList(), hintsAfter("buzz\n", 9, AssignmentHint("New.", "some new condition")))
    }
}
