package robotran.cli.run

import robotran.cli.CommandTest
import robotran.language.Language
import robotran.projects.Assignment
import robotran.projects.AssignmentChecks
import robotran.projects.Project
import robotran.projects.WorldVariation
import robotran.projects.writeProject
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** Runs and grades in worlds whose robot somebody still builds in the workbench. */
class UnfinishedRobotTest : CommandTest() {
    private fun worldText(draft: String) =
        """{"format": "robotran-world", "version": 2, "title": "Ahead", "paper": {"width": 100, "height": 80},
           "robots": [{"start": {"x": 50, "y": 40, "heading": 0}, "robot": "nxt-penbot"$draft}], "timeLimit": 8,
           "goals": [{"kind": "reach", "region": {"circle": {"x": 80, "y": 40, "radius": 5}}, "stays": true}]}"""

    private val unfinishedText =
        worldText(""", "draft": {"title": "One motor", "like": "nxt-penbot", "wheels": {"left": "C"}}""")
    private val unfinished = program(unfinishedText, "draft.world.json")
    private val ahead = program("forward 30\n", "ahead.robo")
    private val reason = "The robot yellow is not finished: \"One motor\" cannot drive. " +
        "Two motors are needed to drive, but left and right are both motor C."

    private fun world(text: String) = assertIs<WorldFileResult.Success>(readWorld(text, Language.ENGLISH)).world

    private fun described(vararg arguments: String): String {
        console.said.clear()
        console.complaints.clear()
        assertEquals(2, commandLine.execute(arguments.toList()))
        assertEquals(emptyList(), console.said)
        return console.complaints.single()
    }

    @Test
    fun `a run is refused in a sentence, in a world and in a project`() {
        assertEquals(reason, described("run", ahead, "--world", unfinished))
        assertContains(
            described("run", ahead, "--world", unfinished, "--language", "de"),
            "Der Roboter yellow ist nicht fertig",
        )
        assertEquals(reason, described("run", program(writeProject(Project(world(unfinishedText))), "mine.robotran")))
    }

    @Test
    fun `grading is refused once, not for each hand-in`() {
        val wrong = program("forwrd 30\n", "wrong.robo")
        assertEquals(reason, described("grade", unfinished, ahead, wrong))
        val checks = AssignmentChecks(1..2, listOf(WorldVariation("other", world(unfinishedText))))
        val assignment = Project(world(worldText("")), assignment = Assignment("a-1", checks = checks))
        assertEquals(reason, described("grade", program(writeProject(assignment), "a.robotran"), ahead, wrong))
    }

    @Test
    fun `a robot file takes the place of what is unfinished`() {
        val robot = tree.resolve("worlds/nxt-penbot.robot.json").path
        for (option in listOf(robot, "yellow=$robot")) {
            val arguments = listOf(ahead, "--robot-file", option)
            assertEquals(0, commandLine.execute(listOf("run", "--world", unfinished) + arguments), "$console")
            assertEquals(0, commandLine.execute(listOf("grade", unfinished) + arguments), "$console")
            val project = Project(world(unfinishedText), assignment = Assignment("a-1"))
            val assignment = program(writeProject(project), "b.robotran")
            assertEquals(0, commandLine.execute(listOf("grade", assignment) + arguments), "$console")
        }
        assertEquals(emptyList(), console.complaints)
    }
}
