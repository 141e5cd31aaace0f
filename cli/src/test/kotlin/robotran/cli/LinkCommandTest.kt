package robotran.cli

import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectSettings
import robotran.projects.openLink
import robotran.projects.writeProject
import robotran.simulation.RecordedInput
import robotran.simulation.SessionInput
import robotran.world.file.BuiltInWorlds
import robotran.world.file.writeWorld
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs

class LinkCommandTest : CommandTest() {
    private fun link(vararg arguments: String) = commandLine.execute(listOf("link") + arguments)

    private fun run(vararg arguments: String) = commandLine.execute(listOf("run") + arguments)

    private fun opened(): LinkResult = runBlocking { openLink(console.said.last(), Language.ENGLISH) }

    private fun file(name: String, text: String): String = folder.resolve(name).apply { writeText(text) }.toString()

    private val squareReport = tree.resolve(
        "shared/simulation/src/commonTest/resources/runs/square.report.json",
    ).readText().trimEnd()

    @Test
    fun `a world becomes a link to the same world`() {
        assertEquals(0, link(file("plain.world.json", writeWorld(BuiltInWorlds.plain))))
        assertEquals(LinkResult.OfWorld(BuiltInWorlds.plain), opened())
    }

    @Test
    fun `a link to a site on this machine says that it works here only`() {
        for (site in listOf("http://localhost:8282/", "http://127.0.0.1:8080/robotran/", "http://[::1]:80/")) {
            console.complaints.clear()
            assertEquals(0, link(square, "--site", site))
            val begin = site.removePrefix("http://").substringBefore('/')
            assertContains(console.complaints.single(), "Links that begin with $begin work on this machine only")
        }
        console.complaints.clear()
        assertEquals(0, link(square, "--site", "https://localhost.school.example/"))
        assertEquals(emptyList(), console.complaints)
    }

    @Test
    fun `a program becomes a project on the plain sheet that runs as the program does`() {
        assertEquals(0, link(square))
        val project = assertIs<LinkResult.OfProject>(opened()).project
        assertEquals(BuiltInWorlds.plain, project.world)
        assertEquals(listOf("square.robo"), project.robots.single().programs.map { it.name })
        assertEquals(0, run("https://school.example/" + console.said.last(), "--report", "-"))
        assertEquals(squareReport, console.said.last())
    }

    @Test
    fun `a Java program leaves the folders of this machine behind`() {
        assertEquals(0, link(tree.resolve("examples/lejos/Square.java").toString()))
        assertEquals(
            listOf("Square.java"),
            assertIs<LinkResult.OfProject>(opened()).project.robots.single().programs.single().files.map { it.name },
        )
    }

    @Test
    fun `a project becomes a link to the same project, and both run alike`() {
        link(square)
        val project = assertIs<LinkResult.OfProject>(opened()).project
        val file = file("square.robotran", writeProject(project))
        assertEquals(0, link(file))
        assertEquals(LinkResult.OfProject(project), opened())
        assertEquals(0, run(file, "--report", "-"))
        assertEquals(squareReport, console.said.last())
    }

    @Test
    fun `what was done to the buttons in a project is done again`() {
        link(square)
        val press = RecordedInput(2000, SessionInput.Press(BrickButton.RUN))
        val release = RecordedInput(2100, SessionInput.Release(BrickButton.RUN))
        val project = assertIs<LinkResult.OfProject>(opened()).project.copy(inputs = listOf(press, release))
        val file = file("later.robotran", writeProject(project))
        assertEquals(0, run(file, "--report", "-"))
        val byItself = console.said.last()
        assertEquals(0, run(square, "--press", "run@2", "--report", "-"))
        assertEquals(byItself, console.said.last())
    }

    @Test
    fun `settings of a project count unless the command line says otherwise`() {
        link(square)
        val project = assertIs<LinkResult.OfProject>(
            opened(),
        ).project.copy(settings = ProjectSettings(seed = 7, realism = 1.0))
        val file = file("shaky.robotran", writeProject(project))
        run(file, "--report", "-")
        val shaky = console.said.last()
        run(square, "--seed", "7", "--realism", "1", "--report", "-")
        assertEquals(console.said.last(), shaky)
        run(file, "--realism", "0", "--report", "-")
        assertContains(console.said.last(), Regex("\"traceHash\": \"[0-9a-f]{16}\"").find(squareReport)!!.value)
    }

    @Test
    fun `a world in a link is run with the programs it has`() {
        val robot = BuiltInWorlds.plain.robots.single().copy(program = "forward 5")
        assertEquals(0, link(file("own.world.json", writeWorld(BuiltInWorlds.plain.copy(robots = listOf(robot))))))
        assertEquals(0, run(console.said.last(), "--report", "-"))
        assertContains(console.said.last(), Regex("\"x\": 4[45]\\."))
    }

    @Test
    fun `with the address of a site the link is whole`() {
        assertEquals(0, link(square, "--site", "https://school.example/robotran/"))
        assertContains(console.said.last(), Regex("^https://school.example/robotran/#p=a\\S+$"))
        assertIs<LinkResult.OfProject>(opened())
        assertEquals(2, link(square, "--site", "school.example"))
        assertContains(console.complaints.last(), "school.example is not the address of a site")
    }

    @Test
    fun `programs go into the world of a project, beside its other robots`() {
        assertEquals(0, link(square, "--world", tree.resolve("worlds/maze.world.json").path))
        val maze = assertIs<LinkResult.OfProject>(opened()).project
        assertEquals(0, link(program("beep\n"), "--world", file("maze.robotran", writeProject(maze))))
        val project = assertIs<LinkResult.OfProject>(opened()).project
        assertEquals(maze.world, project.world)
        assertEquals(listOf("mine.robo"), project.robots.single().programs.map { it.name })
    }

    @Test
    fun `what cannot be linked to or opened is told in a sentence`() {
        fun complaint(status: Int) = console.complaints.last().also { assertEquals(2, status) }
        assertContains(complaint(link(folder.resolve("no.robo").toString())), "There is no file")
        assertContains(complaint(link(file("empty.robotran", "{}"))), "This is not a Robotran project")
        assertContains(complaint(link(file("empty.world.json", "{}"))), "This is not a Robotran world")
        assertContains(
            complaint(link(square, "--world", file("broken.world.json", "{"))),
            "Line 1 opens a { that no } closes",
        )
        assertContains(
            complaint(link(file("a.world.json", "{}"), "--world", "b.world.json")),
            "--world goes with programs only",
        )
        assertContains(complaint(run("#p=aAAAA")), "The link is broken or not whole")
        val project = file("b.robotran", "{}")
        assertContains(
            complaint(run(project, "--robot", "red=$square")),
            "--robot goes with it only together with --world",
        )
        val wrong = file("wrong.robo", "forwrd 5")
        assertEquals(0, link(wrong))
        assertContains(complaint(run(console.said.last())), "wrong.robo:1:1: ")
    }

    @Test
    fun `a program that is compiled is refused`() {
        val jar = folder.resolve("a.class").apply { writeText("no class file") }.toString()
        assertEquals(2, link(jar))
        assertEquals(
            "$jar is compiled: a link takes programs as they were written, .robo or .java.",
            console.complaints.last(),
        )
    }

    @Test
    fun `a project without anything to run says where the robot stayed`() {
        assertEquals(0, run(file("bare.robotran", writeProject(Project(BuiltInWorlds.plain)))))
        assertContains(console.said.last(), "The robot is at x 40.0 cm, y 30.0 cm")
    }
}
