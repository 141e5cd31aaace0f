package robotran.cli.packaging

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.cli.CommandTest
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.Assignment
import robotran.projects.AssignmentChecks
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.openLink
import robotran.projects.writeProject
import robotran.world.file.BuiltInWorlds
import java.util.zip.ZipFile
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

class PackageCommandTest : CommandTest() {
    private val site by lazy {
        program("<p>the page</p>", "site/index.html")
        program("compressed", "site/index.html.br")
        folder.resolve("site").toString()
    }
    private val assignment by lazy {
        val checks = AssignmentChecks(1..20)
        program(
            writeProject(Project(BuiltInWorlds.plain, assignment = Assignment("a1", checks = checks))),
            "a.robotran",
        )
    }
    private val output get() = folder.resolve("out.zip")

    private fun make(vararg arguments: String) =
        commandLine.execute(listOf("package", "--site", site, "-o", output.toString()) + arguments)

    @Test
    fun `a package holds site, wrapper and manifest`() {
        assertEquals(0, make(assignment), console.complaints.toString())
        ZipFile(output.toFile()).use { zip ->
            val names = zip.entries().asSequence().map { it.name }.toList()
            assertContains(names, "imsmanifest.xml")
            assertContains(names, "start.html")
            assertContains(names, "site/index.html")
            assertFalse("site/index.html.br" in names)
        }
    }

    @Test
    fun `the older standard is there on request`() {
        assertEquals(0, make("--scorm", "1.2", assignment))
        ZipFile(output.toFile()).use { zip ->
            val manifest = zip.getInputStream(zip.getEntry("imsmanifest.xml")).readBytes().decodeToString()
            assertContains(manifest, "<schemaversion>1.2</schemaversion>")
        }
    }

    @Test
    fun `an assignment for an NXT comes back with its robot and its programs`() {
        val java = "import lejos.nxt.*;\nclass Go { public static void main(String[] a) { Motor.A.rotate(90); } }\n"
        val world = BuiltInWorlds.plainFor(BrickKind.NXT).copy(title = "Turn a wheel")
        val robot = ProjectRobot(
            world.robots.first().name,
            listOf(ProjectProgram(Program("Go.java", ProgramLanguage.JAVA, java))),
        )
        val project = Project(world, listOf(robot), assignment = Assignment("n1", words = listOf("turned")))
        assertEquals(0, make(program(writeProject(project), "n.robotran")), console.complaints.toString())
        val script = ZipFile(output.toFile()).use { zip ->
            zip.getInputStream(zip.getEntry("assignments.js")).readBytes().decodeToString()
        }
        val link = script.substringAfter('"').substringBefore('"')
        val opened = assertIs<LinkResult.OfProject>(runBlocking { openLink(link, Language.ENGLISH) }).project
        assertEquals(project.world, opened.world)
        assertEquals(project.robots, opened.robots)
        assertEquals(listOf("turned"), opened.assignment?.words)
    }

    @Test
    fun `a project without a task is refused in a sentence`() {
        val project = program(writeProject(Project(BuiltInWorlds.plain)), "p.robotran")
        assertEquals(2, make(project))
        assertContains(console.complaints.single(), "p.robotran is no assignment")
        assertFalse(output.toFile().exists())
    }

    @Test
    fun `without a site it says how to make one`() {
        assertEquals(2, commandLine.execute(listOf("package", "--site", "$folder", "-o", "$output", assignment)))
        assertTrue(console.complaints.single().endsWith("./gradlew :webApp:dist makes it."))
    }
}
