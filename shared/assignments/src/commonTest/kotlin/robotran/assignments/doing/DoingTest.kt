package robotran.assignments.doing

import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.Assignment
import robotran.projects.AssignmentPicture
import robotran.projects.AssignmentTries
import robotran.projects.BestTry
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.TryResult
import robotran.projects.readProject
import robotran.projects.writeProject
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.world.file.BuiltInWorlds
import kotlin.io.encoding.Base64
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class DoingTest {
    private val world = BuiltInWorlds.plain

    private fun program(text: String, name: String = "a.robo", language: ProgramLanguage = ProgramLanguage.ROBOLANG) =
        ProjectProgram(Program(name, language, text))

    private fun project(assignment: Assignment, vararg programs: ProjectProgram) =
        Project(world, listOf(ProjectRobot(world.robots.first().name, programs.toList())), assignment = assignment)

    private fun best(goalsMet: Int, milliseconds: Long) = BestTry(
        listOf(program("wait $milliseconds")),
        0,
        emptyList(),
        TryResult(goalsMet, maxOf(2, goalsMet), milliseconds, ""),
    )

    @Test
    fun `the best try has most goals, then least time`() {
        val tries = listOf(best(1, 500), best(2, 900), best(2, 800), best(2, 850), best(1, 10))
            .fold(AssignmentTries()) { tries, ended -> tries.with(ended, isNew = true, emptyList()) }
        assertEquals(5, tries.tries)
        assertEquals(best(2, 800), tries.best)
        assertEquals(5, tries.with(best(3, 999), isNew = false, emptyList()).tries)
    }

    @Test
    fun `of tries with as many goals, a changed one is better than the start, then the nearest, then the latest`() {
        val start = listOf(program("// Begin.\n"))

        fun ended(text: String, percent: Int?, goalsMet: Int = 0, milliseconds: Long = 900) =
            BestTry(listOf(program(text)), 0, emptyList(), TryResult(goalsMet, 1, milliseconds, ""), percent)

        fun bestOf(vararg tries: BestTry) =
            tries.fold(AssignmentTries()) { all, ended -> all.with(ended, isNew = true, start) }.best

        val untouched = ended("// Begin.\n", 90, milliseconds = 1)
        val near = ended("near", 80)
        val far = ended("far", 20)
        assertEquals(near, bestOf(untouched, near, far))
        assertEquals(near, bestOf(far, near, untouched))
        assertEquals(ended("late", 20), bestOf(far, ended("late", 20)))
        assertEquals(far, bestOf(ended("old", null), far))
        assertEquals(ended("no goals", null), bestOf(ended("first", null), ended("no goals", null)))
        val quick = ended("quick", 100, goalsMet = 1, milliseconds = 500)
        assertEquals(quick, bestOf(near, quick, ended("slow", 100, goalsMet = 1), far))
    }

    @Test
    fun `how near goals are is the mean of all`() {
        val goals = listOf(
            GoalProgress("", GoalStatus.MET, 1.0),
            GoalProgress("", GoalStatus.FAILED, 0.5),
            GoalProgress("", GoalStatus.FAILED, 0.0),
        )
        assertEquals(50, percentOf(goals))
        assertNull(percentOf(emptyList()))
    }

    @Test
    fun `who would begin with the solution begins with an empty program`() {
        val solution = program("forward 5\n")
        val copy = pupilCopy(project(Assignment("x", solution = listOf(solution)), solution))
        assertEquals("", copy.firstPrograms.single().files.single().text)
    }

    @Test
    fun `a hand-in that is written and read again is intact, and one that was changed is not`() {
        val project = project(Assignment("x", text = "Long text."), program("forward 5\n"))
        val handIn = makeHandIn(project, "Ada", HandedInWork(project.firstPrograms))
        val again = assertIs<ProjectFileResult.Success>(readProject(writeProject(handIn), Language.ENGLISH)).project
        assertTrue(isIntact(again))
        assertEquals(Assignment("x"), again.assignment)
        assertFalse(isIntact(again.copy(handIn = again.handIn?.copy(name = "Bob"))))
    }

    @Test
    fun `a name is one line without blanks around it and without half letters`() {
        assertEquals("Ada B", handInName("  Ada\tB \n"))
        assertEquals("", handInName(" \n "))
        assertEquals("x".repeat(99), handInName("x".repeat(99) + "🤖"))
    }

    @Test
    fun `words that are not allowed are told at the line of the first, comments do not count`() {
        val assignment = Assignment("x", words = listOf("forward"), languages = listOf(ProgramLanguage.ROBOLANG))
        val text = "forward 5 // beep\n\nbeep\nBEEP\nrepeat 2 times\n  forward 1\nend\n"
        assertEquals(
            setOf(NotAllowed.HasWord("a.robo", "beep", 3), NotAllowed.HasWord("a.robo", "repeat", 5)),
            notAllowedIn(assignment, listOf(program(text))).toSet(),
        )
        val java = program("class A {}", "A.java", ProgramLanguage.JAVA)
        assertEquals(
            listOf(NotAllowed.InLanguage("A.java", ProgramLanguage.JAVA)),
            notAllowedIn(assignment, listOf(java)),
        )
        assertEquals(emptyList(), notAllowedIn(Assignment("x"), listOf(program(text), java)))
    }

    @Test
    fun `only pictures that fit into memory are shown`() {
        val dot = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPhfDwAChwGA60e6kgAAAABJRU5ErkJggg=="
        assertNotNull(AssignmentPicture("dot", dot).bytesToShow())
        val huge = Base64.decode(dot).also { bytes -> for (index in 16..23) bytes[index] = 0x7F }
        assertNull(AssignmentPicture("huge", Base64.encode(huge)).bytesToShow())
        assertNull(AssignmentPicture("text", Base64.encode("no picture".encodeToByteArray())).bytesToShow())
        assertNull(AssignmentPicture("broken", "=A=").bytesToShow())
        val jpeg = byteArrayOf(-1, -40, -1, -32, 0, 4, 0, 0, -1, -64, 0, 11, 8, 0, 2, 0, 3, 1)
        assertTrue(canBeShown(jpeg))
        assertFalse(canBeShown(jpeg.copyOf(10)))
    }
}
