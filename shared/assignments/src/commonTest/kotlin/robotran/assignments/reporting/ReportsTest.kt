package robotran.assignments.reporting

import kotlinx.coroutines.test.runTest
import robotran.assignments.ASSIGNMENT
import robotran.assignments.DRAWS
import robotran.assignments.collect
import robotran.assignments.comparing.compareSubmissions
import robotran.assignments.file
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.HandInGrader
import robotran.assignments.grading.gradeAll
import robotran.assignments.handIn
import robotran.assignments.robolang
import robotran.language.Language
import robotran.projects.FeedbackResult
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.picture.NoWorldPictures
import robotran.simulation.picture.WorldPictures
import robotran.simulation.state.SessionState
import robotran.world.World
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue

class ReportsTest {
    private suspend fun report(language: Language = Language.ENGLISH): ClassReport {
        val long = DRAWS + "wait 1 seconds\nbeep\n".repeat(3)
        val submissions = collect(
            file("a.robotran", handIn("Anna, the \"first\"", tries = 3)),
            file("b.robotran", handIn("=1+2", listOf(robolang("// <script>alert(1)</script>\n$long")))),
            file("c.robotran", handIn("+1+2", listOf(robolang(long)))),
            file("cem.robo", "forwrd\n"),
            file("dora.pdf", ""),
        )
        val plan = GradingPlan.of(ASSIGNMENT)
        val grader = HandInGrader(ASSIGNMENT, plan, loadPhysicsEngine(), language)
        val results = gradeAll(grader, submissions) { runs -> runs.map { it.finish() } }
        val pairs = compareSubmissions(submissions, ASSIGNMENT)
        return ClassReport(ASSIGNMENT, plan, results, pairs, mapOf(0 to "Well <done>!\nGo on."))
    }

    @Test
    fun `the table has a row for each hand-in and no formulas`() = runTest {
        val lines = csvReport(report()).split("\r\n")
        assertEquals("name,verdict,goals met,goals,seeds met,seeds,seconds,lines,tries,remarks", lines[0])
        assertTrue(lines[1].startsWith("\"Anna, the \"\"first\"\"\",solved,1,1,4,4,"), lines[1])
        assertTrue(lines[1].endsWith(",2,3,"), lines[1])
        assertTrue(lines[2].startsWith("'=1+2,solved,"), lines[2])
        assertTrue(lines[3].startsWith("'+1+2,solved,"), lines[3])
        assertTrue(lines[4].startsWith("cem,has mistakes,,,,,,1,,"), lines[4])
        assertTrue("cem.robo:1:1: " in lines[4], lines[4])
        assertEquals("dora,cannot be used,,,,,,,,\"There is no program, no project and no link in it.\"", lines[5])
        assertEquals("", lines.drop(6).single())
        for (language in Language.entries) {
            val table = csvReport(report(language), language).lines()
            assertEquals(10, table.first().split(',').size)
        }
    }

    @Test
    fun `the page escapes what pupils write and loads nothing`() = runTest {
        val page = htmlReport(report(), null)
        assertFalse("<script" in page || "<img" in page, page)
        assertTrue("// &lt;script&gt;alert(1)&lt;/script&gt;" in page)
        assertTrue("Well &lt;done&gt;!\nGo on." in page)
        assertTrue("<td>1 of 1</td><td>2 of 2</td><td>2 of 2</td>" in page, page)
        assertTrue("=1+2 and +1+2 have the same program." in page, page)
        assertFalse("http:" in page || "https:" in page)
        val drawn = object : WorldPictures by NoWorldPictures {
            override fun svg(world: World, state: SessionState) = "<svg/>"
        }
        assertEquals(3, htmlReport(report(), drawn).split("<img alt=\"\" src=\"data:image/svg+xml;base64,PHN2Zy8+\">").size - 1)
    }

    @Test
    fun `feedback is the hand-in with comment and results`() = runTest {
        val report = report()
        val files = feedbackFiles(report)
        assertEquals(listOf("Anna_ the _first_.robotran", "_1_2.robotran", "_1_2 (2).robotran", "cem.robotran"), files.map { it.name })
        val anna = assertIs<ProjectFileResult.Loaded>(readProject(files.first().bytes)).project
        assertEquals("Well <done>!\nGo on.", anna.feedback?.comment)
        assertEquals(listOf(FeedbackResult("", 2, 2), FeedbackResult("other", 2, 2)), anna.feedback?.results)
        assertEquals("Anna, the \"first\"", anna.handIn?.name)
        val cem = checkNotNull(feedbackProject(report, 3))
        assertEquals("draw-1", cem.assignment?.id)
        assertNull(feedbackProject(report, 4))
        val zip = collect(robotran.assignments.collecting.CollectedFile("all.zip", feedbackZip(report)))
        assertEquals(4, zip.size)
    }

    @Test
    fun `lines of code leave out comments and empty lines`() = runTest {
        val submissions = collect(
            file("a.robo", "// so\n\nbeep // here\n  \nbuzz\n"),
            file("B.java", "/* a\n b */ class B {\n // no\n /* x */ int a; /* y\n*/\n}\n"),
        )
        assertEquals(listOf(2, 3), submissions.map { it.linesOfCode })
    }
}
