package robotran.assignments.reporting

import kotlinx.coroutines.test.runTest
import robotran.assignments.ASSIGNMENT
import robotran.assignments.DRAWS
import robotran.assignments.collect
import robotran.assignments.collecting.CollectedFile
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.collectHandIns
import robotran.assignments.comparing.compareSubmissions
import robotran.assignments.file
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.HandInGrader
import robotran.assignments.grading.gradeAll
import robotran.assignments.handIn
import robotran.assignments.robolang
import robotran.language.Language
import robotran.projects.FeedbackResult
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.ProjectRobot
import robotran.projects.readProject
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.picture.NoWorldPictures
import robotran.simulation.picture.WorldPictures
import robotran.simulation.state.SessionState
import robotran.world.World
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
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
        val lines = csvReport(report(), Language.ENGLISH).split("\r\n")
        val seeds = "seeds met (all worlds),seeds (all worlds)"
        val columns = "name,verdict,goals met,goals,$seeds,seconds,lines,tries,remarks"
        assertEquals("$columns,goals met in all runs,nearly the same program,comment", lines[0])
        assertTrue(lines[1].startsWith("\"Anna, the \"\"first\"\"\",solved,1,1,4,4,"), lines[1])
        assertTrue(lines[1].endsWith(",2,3,,1,,\"Well <done>!\nGo on.\""), lines[1])
        assertTrue(lines[2].startsWith("'=1+2,solved,"), lines[2])
        assertTrue(lines[3].startsWith("'+1+2,solved,"), lines[3])
        assertTrue(lines[4].startsWith("cem,has mistakes,,,,,,1,,"), lines[4])
        assertTrue(lines[2].endsWith(",1,'+1+2 (100 %),") && lines[3].endsWith(",1,'=1+2 (100 %),"), lines[2])
        assertTrue("cem.robo:1:1: " in lines[4], lines[4])
        assertEquals("dora,cannot be used,,,,,,,,\"There is no program, no project and no link in it.\",,,", lines[5])
        assertEquals("", lines.drop(6).single())
    }

    @Test
    fun `German and Spanish tables have semicolons and decimal commas`() = runTest {
        for ((language, verdict) in listOf(Language.GERMAN to "gelöst", Language.SPANISH to "resuelta")) {
            val lines = csvReport(report(language), language).split("\r\n")
            assertEquals(13, lines.first().split(';').size)
            val row = "\"Anna, the \"\"first\"\"\";$verdict;1;1;4;4;\\d+,\\d;2;3;;1;;\"Well <done>!\nGo on.\""
            assertTrue(
                Regex(row) matches lines[1],
                lines[1],
            )
            assertTrue(lines[2].startsWith("'=1+2;$verdict;"), lines[2])
            assertContentEquals(BYTE_ORDER_MARK, csvFile(report(language), language).take(3).toByteArray())
        }
    }

    @Test
    fun `no name becomes a formula, and separators are quoted`() = runTest {
        val plain = listOf("=1+2", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1")
        val wide = listOf("\uFF1D1+2", "\uFF0B1", "\uFF0D1", "\uFF20SUM(A1)", " =1", "\u3000\uFF1D1", "\u22121")
        for (name in plain + wide) {
            val row = csvReport(
                reportOn(
                    handIn("x").let {
                        it.copy(handIn = it.handIn?.copy(name = name))
                    },
                ),
                Language.ENGLISH,
            ).lines()[1]
            assertTrue(row.startsWith("'") || row.startsWith("\"'"), row)
        }
        val separators = reportOn(handIn("a;b,c"))
        assertTrue(csvReport(separators, Language.ENGLISH).lines()[1].startsWith("\"a;b,c\","))
        assertTrue(csvReport(separators, Language.GERMAN).lines()[1].startsWith("\"a;b,c\";"))
    }

    @Test
    fun `what would act instead of being seen is seen`() = runTest {
        val report = reportOn(handIn("Ida").let { it.copy(handIn = it.handIn?.copy(name = "Ida\u001B[31m\u202E")) })
        assertTrue("Ida\\u001b[31m\\u202e" in csvReport(report, Language.ENGLISH), csvReport(report, Language.ENGLISH))
        assertTrue("Ida\\u001b[31m\\u202e" in htmlReport(report, null, Language.ENGLISH))
    }

    @Test
    fun `two pupils of the same name are told apart`() = runTest {
        val anna = reportOn(handIn("Anna"))
        val other = anna.results.map { result ->
            val graded = assertIs<GradedHandIn.Graded>(result)
            graded.copy(graded.submission.copy(name = "anna", origin = "b.robotran"))
        }
        val both = ClassReport(anna.assignment, anna.plan, anna.results + other)
        assertEquals(
            "anna: 2 hand-ins have this name. This one is from b.robotran.",
            remarkLines(both, Language.ENGLISH)[1],
        )
        val rows = csvReport(both, Language.ENGLISH).lines()
        assertTrue(",2 hand-ins have this name. This one is from b.robotran.," in rows[2], rows[2])
        assertFalse("have this name" in csvReport(anna, Language.ENGLISH))
        assertEquals("anna (2) - feedback - Draw.robotran", feedbackFiles(both, Language.ENGLISH)[1].name)
    }

    @Test
    fun `who succeeds in some runs has met the goals in those`() = runTest {
        // Sometimes a little more than needed, sometimes a little less.
        val real = ASSIGNMENT.copy(world = ASSIGNMENT.world.copy(realism = 1.0))
        val report = (100..115).firstNotNullOf { length ->
            val program = robolang("pen down\nforward ${length / 10.0}\n")
            reportOn(handIn("Lea", listOf(program)), 1..14, assignment = real).takeIf { report ->
                val graded = assertIs<GradedHandIn.Graded>(report.results.single())
                graded.runsIn("").count { it.grade.passed } in 1..13
            }
        }
        val graded = report.results.single() as GradedHandIn.Graded
        assertEquals(listOf(1, 0), listOf(graded.goalsMet, graded.goalsMetAlways))
        val row = csvReport(report, Language.ENGLISH).lines()[1]
        assertTrue(row.startsWith("Lea,partly solved,1,1,${graded.met},28,") && row.endsWith(",0,,"), row)
        assertTrue(
            "<p>Reached all goals in ${graded.met} of 28 runs.</p>" in htmlReport(report, null, Language.ENGLISH),
        )
    }

    @Test
    fun `text between backticks is shown as program text`() = runTest {
        val report = reportOn(handIn("Lea"), comment = "Use `turn <left>` and `if`, not ` alone.")
        val comment = "Use <code>turn &lt;left&gt;</code> and <code>if</code>, not ` alone."
        assertTrue("<p class=\"comment\">$comment</p>" in htmlReport(report, null, Language.ENGLISH))
    }

    @Test
    fun `the page tells who has nearly the same program, and what was no hand-in`() = runTest {
        val page = htmlReport(report(), null, Language.ENGLISH)
        assertTrue("<th class=\"words\">nearly the same program</th>" in page, page)
        assertTrue("<td class=\"words\">+1+2 (100 %)</td>" in page, page)
        val given =
            collectHandIns(
                listOf(file("draw.robotran", ASSIGNMENT), file("a.robo", DRAWS)),
                ASSIGNMENT,
                Language.ENGLISH,
            )
        val report = reportOn(handIn("Lea")).let {
            ClassReport(it.assignment, it.plan, it.results, notes = given.notes)
        }
        assertTrue(
            "<li>draw.robotran is the assignment itself, not a hand-in.</li>" in
                htmlReport(report, null, Language.ENGLISH),
        )
    }

    private suspend fun reportOn(
        handIn: Project,
        seeds: IntRange? = null,
        comment: String = "",
        assignment: Project = ASSIGNMENT,
    ): ClassReport {
        val plan = GradingPlan.of(assignment, seeds)
        val grader = HandInGrader(assignment, plan, loadPhysicsEngine(), Language.ENGLISH)
        val submission = Submission.Usable(
            handIn.handIn?.name.orEmpty(),
            "",
            handIn.robots.single(),
            handIn,
            handIn.handIn,
        )
        val results = gradeAll(grader, listOf(submission)) { runs -> runs.map { it.finish() } }
        return ClassReport(ASSIGNMENT, plan, results, comments = mapOf(0 to comment))
    }

    @Test
    fun `the page escapes what pupils write and loads nothing`() = runTest {
        val page = htmlReport(report(), null, Language.ENGLISH)
        assertFalse("<script" in page || "<img" in page, page)
        assertTrue("// &lt;script&gt;alert(1)&lt;/script&gt;" in page)
        assertTrue("Well &lt;done&gt;!\nGo on." in page)
        assertTrue("<td>1 of 1</td><td>2 of 2</td><td>2 of 2</td>" in page, page)
        assertTrue("<th>As given</th><th>other</th><th>seconds (mean)</th>" in page, page)
        assertTrue("=1+2 and +1+2 have the same program." in page, page)
        assertFalse("http:" in page || "https:" in page)
        val drawn = object : WorldPictures by NoWorldPictures {
            override fun svg(world: World, state: SessionState) = "<svg/>"
        }
        assertEquals(
            3,
            htmlReport(
                report(),
                drawn,
                Language.ENGLISH,
            ).split("<img alt=\"\" src=\"data:image/svg+xml;base64,PHN2Zy8+\">").size -
                1,
        )
    }

    @Test
    fun `feedback is the hand-in with comment and results`() = runTest {
        val report = report()
        val files = feedbackFiles(report, Language.ENGLISH)
        assertEquals(
            listOf("Anna, the -first-", "=1+2", "+1+2", "cem", "dora").map { "$it - feedback - Draw.robotran" },
            files.map { it.name },
        )
        val anna = assertIs<ProjectFileResult.Success>(readProject(files.first().bytes, Language.ENGLISH)).project
        assertEquals("Well <done>!\nGo on.", anna.feedback?.comment)
        assertEquals(listOf(FeedbackResult("", 2, 2), FeedbackResult("other", 2, 2)), anna.feedback?.results)
        assertEquals("Anna, the \"first\"", anna.handIn?.name)
        val cem = feedbackProject(report, 3, Language.ENGLISH)
        assertEquals("draw-1", cem.assignment?.id)
        val zip =
            collectHandIns(
                listOf(CollectedFile("all.zip", feedbackZip(report, Language.ENGLISH))),
                ASSIGNMENT,
                Language.ENGLISH,
            )
        assertEquals(listOf(0, 5), listOf(zip.submissions.size, zip.notes.size))
        assertEquals("dora - feedback - Draw.robotran is feedback, not a hand-in.", zip.notes.last())
    }

    @Test
    fun `who has handed in nothing that runs gets feedback, too, and learns why`() = runTest {
        val report = report()
        assertTrue("There is no command" in feedbackProject(report, 3, Language.ENGLISH).feedback?.comment.orEmpty())
        val dora = assertIs<ProjectFileResult.Success>(
            readProject(feedbackFiles(report, Language.ENGLISH).last().bytes, Language.ENGLISH),
        ).project
        assertEquals(
            "Robotran found nothing of yours that it can grade. There is no program, no project and no link in it.",
            dora.feedback?.comment,
        )
        val inSpanish = feedbackProject(report, report.results.lastIndex, Language.SPANISH).feedback?.comment.orEmpty()
        assertTrue(inSpanish.startsWith("Robotran no ha encontrado nada tuyo que pueda evaluar. "), inSpanish)
        assertEquals(report.results.size, feedbackFiles(report, Language.ENGLISH).size)
    }

    @Test
    fun `the zip with feedback is laid out as the platform wants it back`() = runTest {
        val submissions = collect(
            file("all/Mueller Anna_12345_assignsubmission_file_/a.robo", DRAWS),
            file("all/Eva_12349_assignsubmission_onlinetext_/onlinetext.html", "nothing"),
            file("all/meyerben_4712_99888_Fahrt-1.robo", DRAWS),
            file("all/Ida.robo", DRAWS),
        )
        val results = gradeAll(
            HandInGrader(ASSIGNMENT, GradingPlan.of(ASSIGNMENT), loadPhysicsEngine(), Language.ENGLISH),
            submissions,
        ) { runs -> runs.map { it.finish() } }
        assertEquals(
            listOf(
                "Mueller Anna_12345_assignsubmission_file_/Mueller Anna - feedback - Draw.robotran",
                "Eva_12349_assignsubmission_file_/Eva - feedback - Draw.robotran",
                "meyerben_4712_99888_meyerben - feedback - Draw.robotran",
                "Ida - feedback - Draw.robotran",
            ),
            feedbackFiles(ClassReport(ASSIGNMENT, GradingPlan.of(ASSIGNMENT), results), Language.ENGLISH).map {
                it.path
            },
        )
    }

    @Test
    fun `feedback on the teacher's own file keeps the teacher's secrets`() = runTest {
        val secret = robolang("forward 98\n")
        val teachers = ASSIGNMENT.copy(
            robots = listOf(ProjectRobot(ASSIGNMENT.world.robots.first().name, listOf(secret))),
            assignment = ASSIGNMENT.assignment?.copy(solution = listOf(secret)),
        )
        val submissions = collect(file("c/vera/maze.robotran", teachers), file("c/wim/a.robo", DRAWS))
        val report = ClassReport(
            ASSIGNMENT,
            GradingPlan.of(ASSIGNMENT),
            submissions.map { GradedHandIn.HasErrors(it as Submission.Usable, emptyList()) },
        )
        val file = feedbackFiles(report, Language.ENGLISH).first().bytes.decodeToString()
        assertFalse("checks" in file || "solution" in file || "forward 98" in file, file)
    }

    @Test
    fun `lines of code leave out comments and empty lines`() = runTest {
        val submissions = collect(
            file("a.robo", "// so\n\nbeep // here\n  \nbuzz\n"),
            file("B.java", "/* a\n b */ class B {\n // no\n /* x */ int a; /* y\n*/\n}\n"),
        )
        assertEquals(listOf(2, 3), submissions.map { it.linesOfCode })
    }

    @Test
    fun `lines of code are those of the program that Run starts`() = runTest {
        val usable = assertIs<Submission.Usable>(collect(file("a.robo", "beep\n")).single())
        val programs = usable.robot.programs + listOf("buzz\nbeep\nbeep\n").map { text ->
            usable.robot.programs.single().run { copy(program = program.withText(0, text)) }
        }
        val lines = listOf(0, 1).map { usable.copy(robot = usable.robot.copy(programs = programs, firstProgram = it)) }
        assertEquals(listOf(1, 3), lines.map { it.linesOfCode })
    }

    private companion object {
        val BYTE_ORDER_MARK = byteArrayOf(0xEF.toByte(), 0xBB.toByte(), 0xBF.toByte())
    }
}
