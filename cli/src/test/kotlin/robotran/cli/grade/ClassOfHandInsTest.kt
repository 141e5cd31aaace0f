package robotran.cli.grade

import kotlinx.coroutines.runBlocking
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import robotran.assignments.doing.sealedHandIn
import robotran.cli.CommandLine
import robotran.cli.CommandTest
import robotran.documents.ZipEntry
import robotran.documents.zipOf
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.Assignment
import robotran.projects.AssignmentChecks
import robotran.projects.HandIn
import robotran.projects.LinkCreation
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.WorldVariation
import robotran.projects.handInLinkOf
import robotran.projects.writeProject
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import java.util.zip.ZipFile
import kotlin.io.path.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

class ClassOfHandInsTest : CommandTest() {
    private val worldText =
        """{"format": "robotran-world", "version": 2, "title": "Ahead", "paper": {"width": 100, "height": 80},
           "robots": [{"start": {"x": 50, "y": 40, "heading": 0}}], "timeLimit": 8,
           "goals": [{"kind": "reach", "region": {"circle": {"x": 80, "y": 40, "radius": 5}}, "stays": true}]}"""
    private val world: World = assertIs<WorldFileResult.Success>(readWorld(worldText, Language.ENGLISH)).world
    private val worldFile = program(worldText, "ahead.world.json")
    private val nearer = world.copy(robots = world.robots.map { it.copy(start = it.start.copy(x = 40.0)) })
    private val teachers = Project(
        world,
        assignment = Assignment("ahead-1", checks = AssignmentChecks(1..2, listOf(WorldVariation("farther", nearer)))),
    )
    private val assignment = program(writeProject(teachers), "ahead.robotran")

    private fun handIn(name: String, text: String) = sealedHandIn(
        Project(
            world,
            listOf(
                ProjectRobot(
                    world.robots.first().name,
                    listOf(ProjectProgram(Program("go.robo", ProgramLanguage.ROBOLANG, text))),
                ),
            ),
            assignment = Assignment("ahead-1"),
            handIn = HandIn(name, 4, null, ""),
        ),
    )

    private fun link(project: Project) = "https://robotran.example/" +
        assertIs<LinkCreation.Made>(runBlocking { handInLinkOf(project, Language.ENGLISH) }).fragment

    private fun grade(vararg arguments: String, commandLine: CommandLine = this.commandLine): Int {
        console.said.clear()
        console.complaints.clear()
        return commandLine.execute(listOf("grade") + arguments)
    }

    /** A class as a learning platform exports it. */
    private fun submissions(): String {
        program("forward 30\n", "subs/Anna M_1_assignsubmission_file_/prog.robo")
        program(writeProject(handIn("Ben", "forward 30\n")), "subs/Ben K_2_assignsubmission_file_/ben.robotran")
        program("forwrd 30\n", "subs/Cem_3_assignsubmission_file_go.robo")
        program("scan", "subs/Dora_4_assignsubmission_file_/page.jpg")
        program(link(handIn("Eva", "forward 10\n")), "subs/Eva_5_assignsubmission_onlinetext_/onlinetext.html")
        val zip = zipOf(listOf(ZipEntry("work/go.robo", "forward 30\n".encodeToByteArray())))
        folder.resolve("subs/Fay_6_assignsubmission_file_work.zip").writeBytes(zip)
        program("junk", "subs/.DS_Store")
        return folder.resolve("subs").toString()
    }

    @Test
    fun `a folder of submissions has a row for each pupil`() {
        assertEquals(2, grade(worldFile, submissions()), console.complaints.joinToString())
        val said = console.said.single()
        assertContains(said, Regex("Anna M +\\| +1 of 1"))
        assertContains(said, Regex("Ben K +\\| +1 of 1"))
        assertContains(said, Regex("Cem +\\| +- \\| It cannot run: it has mistakes."))
        assertContains(said, Regex("Dora +\\| +- \\| It cannot be used."))
        assertContains(said, Regex("Eva +\\| +0 of 1 \\| Drive your robot to the marked area"))
        assertContains(said, Regex("Fay +\\| +1 of 1"))
        assertEquals(2, console.complaints.size, console.complaints.joinToString())
        assertTrue(console.complaints[0].startsWith("Cem: go.robo:1:1: "), console.complaints[0])
        assertEquals("Dora: There is no program, no project and no link in it.", console.complaints[1])
    }

    @Test
    fun `an assignment's checks decide, also about single hand-ins`() {
        val anna = program(writeProject(handIn("Anna", "forward 30\n")), "a.robotran")
        assertEquals(1, grade(assignment, anna, link(handIn("Ben", "forward 37\n"))))
        assertContains(console.said.single(), Regex("Anna +\\| +2 of 4"))
        assertContains(console.said.single(), Regex("Ben +\\| +2 of 4"))
        val report = folder.resolve("report.json")
        val junit = folder.resolve("junit.xml")
        assertEquals(1, grade(assignment, anna, "--seeds", "5", "--report", "$report", "--junit", "$junit"))
        val runs = Json.parseToJsonElement(report.readText()).jsonObject.getValue("programs").jsonArray.single()
            .jsonObject.getValue("runs").jsonArray.map { it.jsonObject }
        assertEquals(listOf(null, "farther"), runs.map { it["world"]?.jsonPrimitive?.content })
        assertContains(junit.readText(), "name=\"farther, seed 5\"")
    }

    @Test
    fun `a folder, a zip and a sorted zip get the same table`() {
        val files = listOf("loesung.robo" to "forward 30\n", "alt.robo" to "beep\n")
            .map { (name, text) -> "Igor_1_assignsubmission_file_/$name" to text }
        files.forEach { (name, text) -> program(text, "iw/$name") }
        val zips = listOf(files, files.sortedBy { it.first }).mapIndexed { index, entries ->
            val zip = zipOf(entries.map { (name, text) -> ZipEntry(name, text.encodeToByteArray()) })
            folder.resolve("iw$index.zip").also { it.writeBytes(zip) }.toString()
        }
        val tables = (listOf(folder.resolve("iw").toString()) + zips).map {
            assertEquals(0, grade(worldFile, it, "--csv", "-"))
            console.said.single()
        }
        assertContains(tables[0], "Igor,solved,")
        assertContains(tables[0], "alt.robo and loesung.robo were run: loesung.robo counts, none did better.")
        assertEquals(List(3) { tables[0] }, tables)
    }

    @Test
    fun `a renamed Java file is graded by its class, alone and as a platform names it`() {
        val java = "import josx.platform.rcx.*;\npublic class Fahrt { public static void main(String[] a) { } }"
        val alone = program(java, "one/Fahrt (1).java")
        assertEquals(1, grade(worldFile, alone), console.complaints.joinToString())
        program(java, "canvas/mullercarl_late_4712_99888_Fahrt-1.java")
        program(java, "canvas/Fahrt (1).java")
        assertEquals(1, grade(worldFile, folder.resolve("canvas").toString()), console.complaints.joinToString())
        assertContains(console.said.single(), Regex("mullercarl +\\| +0 of 1"))
        assertContains(console.said.single(), Regex("Fahrt \\(1\\) +\\| +0 of 1"))
    }

    @Test
    fun `the source counts beside what was compiled of it, with a word`() {
        program("public class Fahrt { public static void main(String[] a) { } }", "blue/Fahrt.java")
        program("old", "blue/Fahrt.class")
        program("", "blue/package.bluej")
        program("", "blue/README.TXT")
        val blue = folder.resolve("blue").toString()
        assertEquals(1, grade(worldFile, blue), console.complaints.joinToString())
        assertEquals(listOf("In $blue, the Java files count, and the compiled classes do not."), console.complaints)
        console.complaints.clear()
        assertEquals(0, commandLine.execute(listOf("run", blue)), console.complaints.joinToString())
        assertContains(console.complaints, "In $blue, the Java files count, and the compiled classes do not.")
    }

    @Test
    fun `a pupil's empty folder is a row`() {
        program("forward 30\n", "some/Anna/prog.robo")
        folder.resolve("some/Ben").createDirectories()
        assertEquals(2, grade(worldFile, folder.resolve("some").toString()))
        assertEquals(listOf("Ben: The folder is empty."), console.complaints)
    }

    @Test
    fun `a report is in one language`() {
        val anna = program("forward 5\n", "anna.robo")
        val junit = folder.resolve("junit.xml")
        assertEquals(1, grade(worldFile, anna, "--language", "de", "--junit", "$junit"))
        assertContains(junit.readText(), "name=\"Startzahl ")
        assertContains(junit.readText(), "(bei 0,7 s, bei x 55 cm")
    }

    @Test
    fun `feedback goes into the folders of the platform, also for those who have handed in nothing`() {
        val zip = folder.resolve("feedback.zip")
        assertEquals(2, grade(worldFile, submissions(), "--feedback", "$zip"))
        val names = ZipFile(zip.toFile()).use { file -> file.entries().toList().map { it.name } }
        assertEquals(6, names.size)
        assertContains(names, "Dora_4_assignsubmission_file_/Dora - feedback - Ahead.robotran")
        assertContains(names, "Eva_5_assignsubmission_file_/Eva - feedback - Ahead.robotran")
    }

    @Test
    fun `a course is graded in one table`() {
        val other = world.copy(title = "The other one", robots = nearer.robots)
        val second = Project(other, assignment = Assignment("other-1", checks = AssignmentChecks(1..2)))
        program(writeProject(second), "course/other.robotran")
        program(writeProject(teachers), "course/ahead.robotran")
        val list = """{"format": "robotran-course", "version": 1, "title": "Both",
            "assignments": ["ahead.robotran", "other.robotran"]}"""
        program(list, "course/course.json")
        val ofOther = handIn("Anna", "forward 40\n").let {
            sealedHandIn(it.copy(world = other, assignment = Assignment("other-1")))
        }
        program(writeProject(handIn("Anna", "forward 30\n")), "all/anna1.robotran")
        program(writeProject(ofOther), "all/anna2.robotran")
        program("forward 40\n", "all/The other one/Ben.robo")
        program("forward 40\n", "all/Cem.robo")
        program(link(ofOther.let { sealedHandIn(it.copy(handIn = it.handIn?.copy(name = "Dora"))) }), "all/links.txt")
        val csv = folder.resolve("course.csv")
        val course = folder.resolve("course").toString()
        assertEquals(2, grade(course, folder.resolve("all").toString(), "--csv", "$csv"), "${console.complaints}")
        val rows = csv.readText().split("\r\n").map { it.split(',').take(3) }
        assertEquals(
            listOf(
                listOf("\uFEFFname", "assignment", "verdict"),
                listOf("Anna", "Ahead", "partly solved"),
                listOf("Anna", "The other one", "solved"),
                listOf("Ben", "The other one", "solved"),
                listOf("Cem", "", "cannot be used"),
                listOf("Dora", "The other one", "solved"),
            ),
            rows.dropLast(1),
        )
        val html = folder.resolve("course.html")
        grade(course, folder.resolve("all").toString(), "--html", "$html")
        assertContains(html.readText(), "<h2>The other one</h2>")
    }

    @Test
    fun `a table for a spreadsheet and a page are written`() {
        val subs = submissions()
        val csv = folder.resolve("out/class.csv")
        val html = folder.resolve("out/class.html")
        assertEquals(2, grade(assignment, subs, "--csv", "$csv", "--html", "$html"))
        assertEquals(0xEF.toByte(), csv.readBytes().first())
        assertContains(csv.readText(), "\r\nAnna M,partly solved,1,1,2,4,")
        assertContains(csv.readText(), "\r\nBen K,partly solved,1,1,2,4,")
        assertContains(html.readText(), "data:image/svg+xml;base64,")
        assertEquals(2, grade(assignment, subs, "--csv", "-"))
        assertTrue(console.said.single().startsWith("name,verdict,"), console.said.single())
        val plain = CommandLine(console, desktop = null)
        assertEquals(2, grade(assignment, subs, "--html", "$html", commandLine = plain))
        assertContains(console.complaints.joinToString(), "The page has no pictures")
        assertFalse("<img" in html.readText())
        assertEquals(2, grade(assignment, subs, "--language", "de", "--csv", "-"))
        assertContains(console.said.single(), Regex("\r\nAnna M;teilweise gelöst;1;1;2;4;\\d,\\d;"))
        assertTrue(console.said.single().startsWith("Name;Ergebnis;"), console.said.single())
    }

    @Test
    fun `zips and texts hold submissions, and similar ones are told`() {
        val long = "forward 30\nwait 1 seconds\nbeep\nbuzz\nwait 2 seconds\nbeep\nbuzz\nbeep\n"
        val entries = listOf("anna/a.robo" to long, "ben/b.robo" to "// mine\n$long", "cem/c.robo" to "forward 30\n")
        val zip = folder.resolve("class.zip")
        zip.writeBytes(zipOf(entries.map { (path, text) -> ZipEntry(path, text.encodeToByteArray()) }))
        val links =
            program("${link(handIn("Dora", "forward 30\n"))}\n${link(handIn("Eva", "forward 29\n"))}\n", "l.txt")
        assertEquals(0, grade(worldFile, "$zip", links), console.complaints.joinToString())
        val said = console.said.single()
        listOf("anna", "ben", "cem", "Dora", "Eva").forEach { name ->
            assertContains(said, Regex("\\| $name +\\| +1 of 1"))
        }
        assertContains(said, "anna and ben have the same program.")
    }

    @Test
    fun `what is no hand-in costs nothing, and pupils of the same name have rows of their own`() {
        program(writeProject(teachers), "class/ahead.robotran")
        program(writeProject(handIn("Anna", "forward 30\n")), "class/one.robotran")
        program(writeProject(handIn("Anna", "forward 10\n")), "class/two.robotran")
        assertEquals(1, grade(assignment, "$folder/class"))
        assertEquals("ahead.robotran is the assignment itself, not a hand-in.", console.complaints.single())
        val said = console.said.single()
        assertContains(said, Regex("Anna +\\| +2 of 4.+\\R\\| \\(one.robotran\\)"))
        assertContains(said, Regex("Anna +\\| +0 of 4.+\\R\\| \\(two.robotran\\)"))
        assertContains(said, "2 hand-ins have this name. This one is from two.robotran.")
    }

    @Test
    fun `a pupil's own world does not decide, even where it may be changed`() {
        val free = teachers.copy(assignment = teachers.assignment?.copy(mayChangeWorld = true))
        val easy = world.copy(robots = world.robots.map { it.copy(start = it.start.copy(x = 79.0)) })
        val sly = handIn("Sly", "wait 1 seconds\n").copy(world = easy)
        val honest = handIn("Eva", "forward 30\n")
        for (project in listOf(sly, honest)) {
            val marked = project.copy(assignment = project.assignment?.copy(mayChangeWorld = true))
            program(writeProject(sealedHandIn(marked)), "free/${project.handIn?.name}.robotran")
        }
        val task = program(writeProject(free), "free.robotran")
        assertEquals(1, grade(task, "$folder/free"))
        val said = console.said.single()
        assertContains(said, Regex("Sly +\\| +0 of 4"))
        assertContains(said, Regex("Eva +\\| +2 of 4"))
        assertContains(said, "Sly: The world was changed, which the assignment allows.")
        assertFalse("Eva: " in said)
    }

    @Test
    fun `a program has the same grades alone and in a class, with one thread and with several`() {
        val drive = "Motor.A.forward(); Motor.C.forward(); Thread.sleep(2000); Motor.A.stop(); Motor.C.stop();"
        val main = "public static void main(String[] a) throws Exception { $drive }"
        val programs = listOf(
            program("forward 30\n", "go.robo"),
            program("repeat 3 times\n  forward 9\n  turn left 4\nend\n", "bent.robo"),
            program("import josx.platform.rcx.*;\nclass Go { $main }\n", "Go.java"),
        )

        fun runs(vararg arguments: String): Set<String> {
            val report = folder.resolve("report.json")
            grade(worldFile, *arguments, "--seeds", "1..5", "--report", "$report")
            return Json.parseToJsonElement(report.readText()).jsonObject.getValue("programs").jsonArray
                .map { "${it.jsonObject.getValue("runs")}" }.toSet()
        }
        val alone = runs(*programs.toTypedArray())
        assertEquals(3, alone.size)
        for (jobs in listOf("1", "4")) {
            val files = programs.map { folder.resolve("each-${Path(it).name}.zip").toString() }
            programs.zip(files).forEach { (program, file) ->
                Path(file).writeBytes(zipOf(listOf(ZipEntry(Path(program).name, Path(program).readBytes()))))
            }
            assertEquals(alone, runs(*files.toTypedArray(), "--jobs", jobs))
        }
        assertEquals(0, console.complaints.size, console.complaints.joinToString())
    }

    @Test
    fun `hostile and broken hand-ins cost their own row`() {
        program("forward 30\n", "subs/anna/go.robo")
        program("repeat forever\n  var a = 1\nend\n", "subs/endless/go.robo")
        program("{\"format\": \"robotran-project\", \"version\": 99}", "subs/newer/go.robotran")
        folder.resolve("subs/bomb.zip").writeBytes(ByteArray(5_000) { it.toByte() })
        val deep = "static int d(int n) { return d(n + 1) + 1; }"
        program("class D { $deep public static void main(String[] a) { d(1); } }", "subs/deep/D.java")
        assertEquals(2, grade(worldFile, "$folder/subs"))
        val said = console.said.single()
        assertContains(said, Regex("anna +\\| +1 of 1"))
        assertContains(said, Regex("endless +\\| +0 of 1"))
        assertContains(said, Regex("deep +\\| +0 of 1"))
        assertContains(console.complaints.joinToString(), "bomb.zip is damaged, or not a zip file at all.")
    }

    @Test
    fun `folders of one program stay one program, and nothing is told as before`() {
        program("class A { public static void main(String[] a) { B.go(); } }", "project/A.java")
        program("class B { static void go() { } }", "project/B.java")
        program("read me", "project/notes.txt")
        assertEquals(1, grade(worldFile, "$folder/project"))
        assertContains(console.said.single(), "project meets all goals with 0 of 1 seeds")
        program("nothing", "empty/notes.pdf")
        assertEquals(2, grade(worldFile, "$folder/empty"))
        assertEquals("There is no class file in empty.", console.complaints.single())
        assertTrue(folder.resolve("empty").exists())
    }
}
