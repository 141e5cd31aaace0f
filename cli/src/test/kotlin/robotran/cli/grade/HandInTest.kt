package robotran.cli.grade

import kotlinx.coroutines.runBlocking
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import robotran.cli.CommandTest
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.projects.LinkCreation
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.ProjectSettings
import robotran.projects.linkOf
import robotran.projects.writeProject
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** Tests submissions made by the app: `.robotran` files and links. */
class SubmissionTest : CommandTest() {
    private val worldText =
        """{"format": "robotran-world", "version": 2, "title": "Ahead", "paper": {"width": 100, "height": 80},
           "robots": [{"start": {"x": 50, "y": 40, "heading": 0}}, {"name": "red", "start": {"x": 10, "y": 10, "heading": 0}}], "timeLimit": 8,
           "goals": [{"kind": "reach", "region": {"circle": {"x": 80, "y": 40, "radius": 5}}, "stays": true}]}"""
    private val world: World = assertIs<WorldFileResult.Success>(readWorld(worldText, Language.ENGLISH)).world
    private val worldFile = file("ahead.world.json", worldText)
    private val ahead = robolang("forward 30\n")
    private val short = robolang("forward 10\n", "short.robo")

    private fun file(name: String, text: String): String = folder.resolve(name).also { it.writeText(text) }.toString()

    private fun robolang(text: String, name: String = "ahead.robo") =
        ProjectProgram(Program(name, ProgramLanguage.ROBOLANG, text))

    private fun java(statements: String): ProjectProgram {
        val main = "  public static void main(String[] a) throws Exception {\n$statements\n  }\n"
        val text = "import josx.platform.rcx.*;\npublic class Ahead {\n$main}\n"
        return ProjectProgram(Program("Ahead", ProgramLanguage.JAVA, listOf(SourceFile("Ahead.java", text))))
    }

    /** A project on the empty sheet, as a pupil at home might write it. */
    private fun work(vararg programs: ProjectProgram, first: Int = 0) = Project(
        BuiltInWorlds.plain,
        listOf(ProjectRobot(BuiltInWorlds.plain.robots.first().name, programs.toList(), first)),
    )

    private fun project(name: String, project: Project) = file(name, writeProject(project))

    private fun link(project: Project): String = "https://robotran.example/" +
        assertIs<LinkCreation.Made>(runBlocking { linkOf(project, Language.ENGLISH) }).fragment

    private fun grade(vararg arguments: String): Int {
        console.said.clear()
        console.complaints.clear()
        return commandLine.execute(listOf("grade") + arguments)
    }

    @Test
    fun `projects and links are graded in the teacher's world, each in its row`() {
        val mona = project("mona.robotran", work(ahead))
        val tim = project("tim.robotran", work(short))
        val lea = link(work(java("    Motor.A.forward();\n    Motor.C.forward();\n    Thread.sleep(1);")))
        val ben = link(work(short, ahead, first = 1))
        assertEquals(1, grade(worldFile, mona, tim, lea, ben), console.complaints.joinToString())
        val said = console.said.single()
        assertContains(said, Regex("mona.robotran +\\| +1 of 1"))
        assertContains(said, Regex("tim.robotran +\\| +0 of 1"))
        assertContains(said, Regex("link 1 +\\| +0 of 1"))
        assertContains(said, Regex("link 2 +\\| +1 of 1"), "the program that the pupil has chosen runs")
        val command = said.lines().first { it.startsWith("$tim: ") }.removePrefix("$tim: ")
        assertEquals("./robotran run $tim --world $worldFile --seed 1 --for 8 --picture tim-1.png", command)
        console.said.clear()
        val again = command.split(' ').drop(1).map { if (it.endsWith(".png")) "$folder/shown.png" else it }
        assertEquals(0, commandLine.execute(again), console.complaints.joinToString())
        assertContains(console.said.single(), "\nnot met (39 %): Drive your robot to the marked area on the right")
    }

    @Test
    fun `a project or a link is the world, too, with its other robots' programs and the seed it is set to`() {
        val rams = ProjectRobot("red", listOf(robolang("forward 40\n", "ram.robo")))
        val reach = worldText.replace(
            "\"stays\": true",
            "\"who\": \"red\"",
        ).replace("\"x\": 80, \"y\": 40", "\"x\": 50, \"y\": 10")
        val place = assertIs<WorldFileResult.Success>(readWorld(reach, Language.ENGLISH)).world
        val teacher = Project(place, listOf(rams), ProjectSettings(seed = 7))
        val waiting = program("wait 7 seconds\n")
        for (shared in listOf(project("teacher.robotran", teacher), link(teacher))) {
            val report = folder.resolve("report.json")
            assertEquals(
                0,
                grade(shared, waiting, "--report", "$report"),
                console.complaints.joinToString() + console.said,
            )
            val run = Json.parseToJsonElement(
                report.toFile().readText(),
            ).jsonObject.getValue("programs").jsonArray.single()
                .jsonObject.getValue("runs").jsonArray.single().jsonObject
            assertEquals("7", run.getValue("seed").jsonPrimitive.content)
        }
        assertEquals(
            1,
            grade(project("teacher.robotran", teacher), waiting, "--robot", "red=$waiting"),
            "what is said counts more",
        )
        assertEquals(2, grade(project("none.robotran", work(ahead)), waiting))
        assertContains(console.complaints.single(), "none.robotran has no goals")
        assertEquals(2, grade("#p=aAAAA", waiting))
        assertEquals(1, console.complaints.size)
    }

    @Test
    fun `mistakes are told with the project that they are in`() {
        val mona = project("mona.robotran", work(robolang("beep\nhop\n")))
        val tim = project("tim.robotran", work(java("    int n = \"x\";")))
        val good = project("good.robotran", work(ahead))
        assertEquals(2, grade(worldFile, mona, tim, good))
        assertContains(console.complaints[0], "$mona: ahead.robo:2:1: ")
        assertContains(console.complaints[1], Regex("tim.robotran: Ahead.java:4:\\d+: "))
        assertContains(console.said.single(), Regex("mona.robotran +\\| +- \\| It cannot run: it has mistakes"))
        assertContains(console.said.single(), Regex("good.robotran +\\| +1 of 1"))
    }

    @Test
    fun `a hand-in that cannot be used has a sentence and a row of its own, and the others are graded`() {
        val bad = listOf(
            project("empty.robotran", Project(BuiltInWorlds.plain)),
            file("text.robotran", "{\"format\": \"robotran-project\", \"version\": 1, \"world\": {}}"),
            file("deep.robotran", "[".repeat(1_000_000)),
            folder.resolve("noise.robotran").also {
                it.writeBytes(ByteArray(100_000) { byte -> (byte * 31).toByte() })
            }.toString(),
            "$folder/missing.robotran",
            "#p=aAAAA",
            "https://robotran.example/#w=" + "a".repeat(50_000),
        )
        val good = project("good.robotran", work(ahead))
        assertEquals(2, grade(worldFile, *bad.toTypedArray(), good))
        assertEquals(bad.size, console.complaints.size, console.complaints.joinToString("\n"))
        assertContains(console.complaints[0], "empty.robotran has no program for its robot")
        assertContains(console.complaints[5], "link 1: The link is broken")
        assertTrue(console.complaints.all { it.length < 300 && '\n' !in it }, console.complaints.joinToString("\n"))
        assertEquals(
            bad.size,
            console.said.single().lines().count {
                "It cannot be used." in it
            },
            console.said.single(),
        )
        assertContains(console.said.single(), Regex("good.robotran +\\| +1 of 1"))
        assertEquals(2, grade(worldFile, bad[0]))
    }

    @Test
    fun `nothing in a name reaches the terminal but letters`() {
        val sly = project("sly.robotran", work(robolang("hop\n", "\u001b[2Jsly.robo")))
        assertEquals(2, grade(worldFile, sly))
        assertContains(console.complaints.single(), "name must be one line of ordinary characters")
        assertFalse('\u001b' in console.complaints.single())
    }
}
