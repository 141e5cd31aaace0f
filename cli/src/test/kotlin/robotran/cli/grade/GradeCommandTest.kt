package robotran.cli.grade

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.boolean
import kotlinx.serialization.json.double
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.w3c.dom.Element
import robotran.cli.CommandTest
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class GradeCommandTest : CommandTest() {
    private val ahead = """{"kind": "reach", "region": {"circle": {"x": 80, "y": 40, "radius": 5}}, "stays": true}"""
    private val noTouch = """{"kind": "neverTouch", "says": "Leave <the> \"walls\" & me alone."}"""
    private val world = world("$ahead, $noTouch")
    private val good = program("forward 30\n", "good.robo")
    private val short = program("forward 10\n", "short.robo")
    private val empty = program("", "empty.robo")

    private fun world(goals: String, more: String = "", name: String = "ahead.world.json"): String =
        folder.resolve(name).also {
            it.writeText(
                """{"format": "robotran-world", "version": 2, "title": "Ahead", "paper": {"width": 100, "height": 80},
                   "robots": [{"start": {"x": 50, "y": 40, "heading": 0}}], "timeLimit": 8 $more, "goals": [$goals]}""",
            )
        }.toString()

    private fun grade(vararg arguments: String): Int {
        console.said.clear()
        console.complaints.clear()
        console.mentions.clear()
        return commandLine.execute(listOf("grade") + arguments)
    }

    private fun jsonOf(vararg arguments: String) = folder.resolve("grades.json").let { file ->
        grade(*arguments, "--report", "$file")
        Json.parseToJsonElement(file.readText()).jsonObject
    }

    private fun junitOf(vararg arguments: String): Element {
        val file = folder.resolve("out/junit.xml")
        grade(*arguments, "--junit", "$file")
        return DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file.toFile()).documentElement
    }

    private fun Element.all(name: String): List<Element> = getElementsByTagName(name).let { found ->
        List(found.length) { found.item(it) as Element }
    }

    @Test
    fun `a program that meets all goals with all seeds is told so`() {
        assertEquals(0, grade(world, good, "--seeds", "1..4"), console.complaints.joinToString())
        val said = console.said.single()
        assertContains(said, "Drive your robot to the marked area on the right, and let it be there at the end.")
        assertContains(said, "$good meets all goals with seeds 1 to 4.")
        assertEquals(2, said.lines().count { "4 of 4" in it && "100 %" in it }, said)
        assertEquals(emptyList(), console.complaints)
    }

    @Test
    fun `an empty program is red, and the command shows its run`() {
        assertEquals(1, grade(world, empty))
        val said = console.said.single()
        assertContains(said, "$empty meets all goals with 0 of 1 seeds (seed 1).")
        val goal = "Drive your robot to the marked area on the right, and let it be there at the end."
        assertContains(said, "Seed 1: \"$goal\" was not met (0 %)")
        assertContains(said, "\n  25 cm short of the marked area. (at 0 s, at x 50 cm, y 40 cm)\n")
        val command = said.lines().last().trim()
        assertEquals("./robotran run $empty --world $world --seed 1 --for 8 --picture empty-1.png", command)
        val picture = folder.resolve("shown.png")
        console.said.clear()
        assertEquals(
            0,
            commandLine.execute(
                command.split(' ').drop(1).map {
                    if (it.endsWith(".png")) "$picture" else it
                },
            ),
        )
        assertTrue(picture.exists())
        assertContains(console.said.single(), "\nnot met (0 %): Drive your robot to the marked area on the right")
        assertContains(console.said.single(), "\nmet: Leave <the>")
    }

    @Test
    fun `a report says what was missing, how much, when, where and in which line`() {
        val run = jsonOf(world, program("wait 1 second\nforward 10\n")).getValue("programs").jsonArray.single()
            .jsonObject.getValue("runs").jsonArray.single().jsonObject
        val goal = run.getValue("report").jsonObject.getValue("goals").jsonArray.first().jsonObject
        val shortfall = goal.getValue("shortfall").jsonObject
        assertEquals("not-reached", shortfall.getValue("kind").jsonPrimitive.content)
        assertEquals(15.0, shortfall.getValue("centimetres").jsonPrimitive.double, 0.3)
        assertEquals(60.0, shortfall.getValue("place").jsonObject.getValue("x").jsonPrimitive.double, 0.3)
        assertEquals(2, shortfall.getValue("line").jsonPrimitive.int)
        assertTrue(shortfall.getValue("seconds").jsonPrimitive.double > 1.0)
        assertContains(shortfall.getValue("sentence").jsonPrimitive.content, "cm short of the marked area.")
        val failure = junitOf(world, program("forward 10\n")).all("failure").single()
        assertContains(failure.textContent, Regex("\n {2}1[0-9.]+ cm short of the marked area. .*in line 1"))
    }

    @Test
    fun `a program that never ends is graded when the time is up`() {
        assertEquals(
            0,
            grade(world, program("forward 30\nrepeat forever\n  wait 1 second\nend\n")),
            console.said.joinToString(),
        )
        val report = jsonOf(world, program("repeat forever\n  beep\n  wait 1 second\nend\n"))
        val run = report.getValue(
            "programs",
        ).jsonArray.single().jsonObject.getValue("runs").jsonArray.single().jsonObject
        assertEquals("8.0", run.getValue("report").jsonObject.getValue("seconds").toString())
        assertFalse(run.getValue("passed").jsonPrimitive.boolean)
    }

    @Test
    fun `a program that fails while it runs is told with its line`() {
        assertEquals(
            1,
            grade(world, program("var n = 0\nforward 10\nforward 10 / n\n")),
            console.complaints.joinToString(),
        )
        assertContains(console.said.single(), "The program failed: Line 3: ")
        val failure = junitOf(world, program("var n = 0\nforward 10 / n\n")).all("failure").single()
        assertContains(failure.textContent, "The program failed: Line 2: ")
    }

    @Test
    fun `JUnit's XML has a case for each seed, and what was said is escaped`() {
        val bumping = program("forward 100\n", "bump & <go>.robo")
        val walled =
            world(noTouch, """, "walls": [{"from": [70, 0], "to": [70, 80], "thickness": 1}]""", "walled.world.json")
        val suites = junitOf(walled, bumping, "--seeds", "3..5")
        val suite = suites.all("testsuite").single()
        assertEquals(listOf("3", "3", "0"), listOf("tests", "failures", "errors").map(suite::getAttribute))
        assertEquals(bumping, suite.getAttribute("name"))
        assertEquals(listOf("seed 3", "seed 4", "seed 5"), suites.all("testcase").map { it.getAttribute("name") })
        assertEquals("Leave <the> \"walls\" & me alone.", suites.all("failure").first().getAttribute("message"))
        assertEquals(
            listOf("Leave <the> \"walls\" & me alone. (0 %)", "  It touched a wall at 0.5 s."),
            suites.all("failure").first().textContent.lines().map { it.substringBefore(" (at ") },
        )
        assertEquals(0, junitOf(world, good).all("failure").size)
    }

    @Test
    fun `JSON has the report of each run`() {
        val report = jsonOf(world, short, "--seeds", "1..2")
        assertEquals("Ahead", report.getValue("title").jsonPrimitive.content)
        val program = report.getValue("programs").jsonArray.single().jsonObject
        assertEquals(0, program.getValue("passed").jsonPrimitive.int)
        val runs = program.getValue("runs").jsonArray.map { it.jsonObject }
        assertEquals(listOf(1, 2), runs.map { it.getValue("seed").jsonPrimitive.int })
        val goals = runs.first().getValue("report").jsonObject.getValue("goals").jsonArray.map { it.jsonObject }
        assertEquals(listOf("failed", "met"), goals.map { it.getValue("status").jsonPrimitive.content })
        assertTrue(goals.first().getValue("progress").jsonPrimitive.double in 0.38..0.4)
    }

    @Test
    fun `a class is told program by program, also one that cannot run`() {
        val mistaken = program("hop\n", "mistaken.robo")
        assertEquals(1, grade(world, good, short, "--seeds", "1..2"))
        assertEquals(2, grade(world, good, mistaken, short, "--seeds", "1..2"))
        val said = console.said.single()
        assertTrue(Regex("good.robo +\\| +2 of 2").containsMatchIn(said), said)
        assertTrue(Regex("short.robo +\\| +0 of 2").containsMatchIn(said), said)
        assertTrue(Regex("mistaken.robo +\\| +- \\| It cannot run").containsMatchIn(said), said)
        assertContains(said, "$short: ./robotran run $short --world $world --seed 1 --for 8 --picture short-1.png")
        assertContains(console.complaints.single(), "$mistaken:1:1: ")
        val suites = junitOf(world, good, mistaken)
        assertEquals(listOf("0", "1"), suites.all("testsuite").map { it.getAttribute("errors") })
        assertContains(suites.all("error").single().textContent, "$mistaken:1:1: ")
    }

    @Test
    fun `what cannot be used is refused in a sentence`() {
        val withoutGoals = world("", name = "none.world.json")
        assertEquals(2, grade(withoutGoals, good))
        assertEquals("The world $withoutGoals has no goals, so there is nothing to grade.", console.complaints.single())
        assertEquals(2, grade(world, program("hop\n", "mistaken.robo")))
        assertContains(console.complaints.single(), "mistaken.robo:1:1: ")
        val seeds = listOf("5..1", "a", "1..2..3", "0..10000", "-1..2").map { "--seeds" to it }
        for ((argument, value) in seeds + listOf("--jobs" to "0", "--realism" to "2", "--robot" to "red")) {
            assertEquals(2, grade(world, good, "$argument=$value"), "$argument $value")
            assertContains(console.complaints.single(), value)
        }
        for (missing in listOf(
            listOf("$folder/missing.world.json", good),
            listOf(world, "$folder/missing.robo"),
            listOf(good, good),
        )) {
            assertEquals(2, grade(*missing.toTypedArray()), "$missing")
            assertEquals(1, console.complaints.size, "$missing")
        }
        assertEquals(2, grade(world, good, "--junit", "$good/junit.xml"))
        assertContains(console.complaints.single(), "junit.xml could not be written")
    }

    @Test
    fun `as many threads as one likes make the same grades, in both languages`() {
        val java =
            javaProgram(
                "Ahead",
                "Motor.A.forward();\nMotor.C.forward();\nThread.sleep(1500);\nMotor.A.stop();\nMotor.C.stop();",
            )
        val noisy = world(ahead, """, "realism": 1""", "noisy.world.json")
        val grades = listOf("1", "8").map { jobs ->
            jsonOf(noisy, good, java, "--seeds", "1..16", "--jobs", jobs).toString()
        }
        assertEquals(grades[0], grades[1])
        val hashes = Regex("\"traceHash\":\"(\\w+)\"").findAll(grades[0]).map { it.groupValues[1] }.toList()
        assertEquals(32, hashes.size)
        assertEquals(32, hashes.toSet().size, "each seed is another run")
    }

    @Test
    fun `how far it is is told only if there is much to do`() {
        grade(world, good, "--seeds", "1..20")
        assertEquals(10, console.mentions.size)
        assertEquals("10 %: 2 of 20 runs\n", console.mentions.first())
        assertEquals("100 %: 20 of 20 runs\n", console.mentions.last())
        grade(world, good)
        assertEquals(emptyList(), console.mentions)
    }

    @Test
    fun `where somebody looks a bar grows and is gone at the end`() {
        val progress = GradeProgress(console, isTerminal = true, total = 8)
        repeat(8) { progress.runIsDone() }
        assertEquals("\r[#####                                   ] 1 of 8 runs", console.mentions.first())
        assertEquals("", console.mentions.last().trim())
    }

    @Test
    fun `a folder of Java sources is one program`() {
        val project = folder.resolve("pupil one").createDirectory()
        project.resolve("Ahead.java").writeText(
            "public class Ahead {\n    public static void main(String[] args) throws Exception {\n        new " +
                "Car().go();\n    }\n}\n",
        )
        project.resolve("Car.java").writeText(
            "import josx.platform.rcx.*;\n\npublic class Car {\n    void go() throws Exception {\n" +
                "        Motor.A.forward();\n        Motor.C.forward();\n        Thread.sleep(500);\n        " +
                "Motor.A.stop();\n        Motor.C.stop();\n    }\n}\n",
        )
        assertEquals(1, grade(world, "$project"), console.complaints.joinToString())
        assertContains(console.said.single(), "./robotran run '$project/Ahead.java' '$project/Car.java' --world")
        assertContains(console.said.single(), "--picture 'pupil one-1.png'")
    }

    @Test
    fun `a dash writes to the console and nothing else is said there`() {
        assertEquals(0, grade(world, good, "--report", "-"))
        assertEquals(
            "Ahead",
            Json.parseToJsonElement(console.said.single()).jsonObject.getValue("title").jsonPrimitive.content,
        )
        assertEquals(0, grade(world, good, "--junit", "-"))
        assertTrue(console.said.single().startsWith("<?xml"))
    }

    @Test
    fun `the time of a run and the other robots can be chosen`() {
        val reach = """{"kind": "reach", "region": {"circle": {"x": 40, "y": 10, "radius": 3}}, "who": "red"}"""
        val two = folder.resolve("two.world.json").also {
            it.writeText(
                """{"format": "robotran-world", "version": 2, "title": "Two", "paper": {"width": 100, "height": 80}, "goals": [$reach],
                   "robots": [{"start": {"x": 50, "y": 40, "heading": 0}}, {"name": "red", "start": {"x": 10, "y": 10, "heading": 0}, "program": ["wait 9 seconds"]}]}""",
            )
        }.toString()
        val waiting = program("wait 10 seconds\n", "waiting.robo")
        assertEquals(1, grade(two, waiting))
        assertEquals(0, grade(two, waiting, "--robot", "red=$good"), console.complaints.joinToString())
        assertEquals(1, grade(two, waiting, "--robot", "red=$good", "--for", "1"))
        assertContains(console.said.single(), "--seed 1 --for 1 --robot red=$good --picture")
        assertEquals(2, grade(two, waiting, "--robot", "blue=$good"))
        assertContains(console.complaints.single(), "blue")
        assertEquals(2, grade(two, waiting, "--robot", "yellow=$good"))
        assertContains(console.complaints.single(), "yellow")
        assertEquals(2, grade(two, waiting, "--robot", "red=${program("hop\n", "hop.robo")}"))
        assertContains(console.complaints.single(), "hop.robo:1:1: ")
    }

    @Test
    fun `the help tells the options and the statuses`() {
        assertEquals(0, grade("--help"))
        for (word in listOf("--seeds", "--jobs", "--junit", "Exit status")) assertContains(console.said.single(), word)
    }
}
