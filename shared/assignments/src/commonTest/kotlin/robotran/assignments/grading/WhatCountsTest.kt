package robotran.assignments.grading

import kotlinx.coroutines.test.runTest
import robotran.assignments.ASSIGNMENT
import robotran.assignments.DRAWS
import robotran.assignments.collecting.CollectedFile
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.SubmissionRemark
import robotran.assignments.collecting.collectHandIns
import robotran.assignments.file
import robotran.assignments.grading.workers.GradingOrder
import robotran.assignments.grading.workers.GradingWorker
import robotran.assignments.grading.workers.readGraded
import robotran.assignments.grading.workers.writeHandIn
import robotran.assignments.handIn
import robotran.assignments.reporting.ClassReport
import robotran.assignments.reporting.csvReport
import robotran.assignments.robolang
import robotran.documents.ZipEntry
import robotran.documents.zipOf
import robotran.language.Language
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull

/** Which program of a hand-in counts, and which hand-in of a pupil. */
class WhatCountsTest {
    private val plan = GradingPlan.of(ASSIGNMENT)

    private suspend fun grader() = HandInGrader(ASSIGNMENT, plan, loadPhysicsEngine(), Language.ENGLISH)

    private suspend fun grade(files: List<CollectedFile>): List<GradedHandIn> {
        val submissions = collectHandIns(files, ASSIGNMENT, Language.ENGLISH).submissions
        return gradeAll(grader(), submissions) { runs -> runs.map { it.finish() } }
    }

    private suspend fun grade(vararg files: CollectedFile) = grade(files.toList())

    private fun remarks(graded: GradedHandIn) = graded.submission.remarks

    private suspend fun table(files: List<CollectedFile>) =
        csvReport(ClassReport(ASSIGNMENT, plan, grade(files).sortedBy { it.submission.name }), Language.ENGLISH)

    private fun zip(files: List<CollectedFile>) =
        listOf(CollectedFile("class.zip", zipOf(files.map { ZipEntry(it.path, it.bytes) })))

    @Test
    fun `a folder and a zip of any order get the same grades`() = runTest {
        val java = "public class Go { public static void main(String[] a) { } }"
        val files = listOf(
            file("Igor_1_assignsubmission_file_/alt.robo", "beep\n"),
            file("Igor_1_assignsubmission_file_/loesung.robo", DRAWS),
            file("Otto_2_assignsubmission_file_/Go.java", java),
            file("Otto_2_assignsubmission_file_/a.robo", DRAWS),
            file("Uwe_3_assignsubmission_file_/one.robotran", handIn("Uwe", listOf(robolang("beep\n")))),
            file("Uwe_3_assignsubmission_file_/two.robotran", handIn("Uwe")),
            file("Vera_4_assignsubmission_file_/new/Go.java", java),
            file("Vera_4_assignsubmission_file_/old/Go.java", "$java // old"),
        )
        val expected = table(files)
        assertEquals(listOf("solved", "solved", "solved"), expected.lines().drop(1).take(3).map { it.split(',')[1] })
        assertEquals(expected, table(files.reversed()))
        assertEquals(expected, table(zip(files)))
        assertEquals(expected, table(zip(files.reversed())))
    }

    @Test
    fun `the row tells which program counts of which`() = runTest {
        val graded = grade(file("c/ida/b.robo", DRAWS), file("c/ida/a.robo", "beep\n"), file("c/jan/x.robo", DRAWS))
        assertEquals(Verdict.PASSED, graded[0].verdict)
        val best = SubmissionRemark.BestCounts("b.robo", listOf("a.robo", "b.robo"))
        assertEquals(listOf(listOf<SubmissionRemark>(best), emptyList()), graded.map(::remarks))
        assertContains(
            csvReport(ClassReport(ASSIGNMENT, plan, graded), Language.ENGLISH),
            "a.robo and b.robo were run: b.robo counts, none did better.",
        )
    }

    @Test
    fun `a program with mistakes does not harm the one beside it`() = runTest {
        val graded = grade(file("c/ida/a.robo", "forwrd\n"), file("c/ida/b.robo", DRAWS), file("c/jan/x.robo", ""))
        assertEquals(Verdict.PASSED, graded[0].verdict)
        val both = grade(file("c/ida/a.robo", "forwrd\n"), file("c/ida/b.robo", "beeep\n"), file("c/jan/x.robo", ""))
        assertContains(assertIs<GradedHandIn.HasErrors>(both[0]).reasons.single(), "a.robo:1:1: ")
    }

    @Test
    fun `of hand-ins with as many tries the better one counts, and it is told`() = runTest {
        val short = handIn("Ida", listOf(robolang("pen down\nforward 2\n")))
        for (paths in listOf("try1" to "final", "x" to "y", "y" to "x")) {
            val graded = grade(
                file("c/ida/${paths.first}.robotran", short),
                file("c/ida/${paths.second}.robotran", handIn("Ida")),
                file("c/jan/x.robo", DRAWS),
            )
            assertEquals(Verdict.PASSED, graded[0].verdict)
            val names = listOf(paths.first, paths.second).sorted().map { "$it.robotran" }
            val best = SubmissionRemark.BestCounts("${paths.second}.robotran", names)
            assertEquals(listOf<SubmissionRemark>(best), remarks(graded[0]))
        }
    }

    @Test
    fun `a worker chooses the same`() = runTest {
        val files = listOf(file("c/ida/a.robo", "beep\n"), file("c/ida/b.robo", DRAWS), file("c/jan/x.robo", DRAWS))
        val ida = collectHandIns(files, ASSIGNMENT, Language.ENGLISH).submissions.first() as Submission.Usable
        val order = assertNotNull(GradingOrder.of(ASSIGNMENT, plan, Language.ENGLISH))
        val text = GradingWorker(order, loadPhysicsEngine()).grade(writeHandIn(ida)) {}
        val start = Session(
            plan.worlds.first().world,
            emptyList<RobotProgramSet>(),
            loadPhysicsEngine(),
            Language.ENGLISH,
        ).state
        val graded = assertIs<GradedHandIn.Graded>(readGraded(text, ida, plan, start))
        assertEquals(grade(files).first().submission, graded.submission)
        assertEquals(plan.runs, graded.met)
    }

    @Test
    fun `all runs of what may count are told as progress`() = runTest {
        val files = listOf(file("c/ida/a.robo", "beep\n"), file("c/ida/b.robo", DRAWS), file("c/jan/x.robo", DRAWS))
        val session = GradingSession(grader(), collectHandIns(files, ASSIGNMENT, Language.ENGLISH).submissions)
        assertEquals(3 * plan.runs, session.state.runsInTotal)
        while (!session.state.isOver) session.step(10_000)
        assertEquals(3 * plan.runs, session.state.runsDone)
        assertEquals(grade(files).map { it.submission }, session.state.results.map { it.submission })
    }

    @Test
    fun `the class decides and not the name of its file`() = runTest {
        val java = "/* class No { } */ public class Fahrt { public static void main(String[] a) { Robot.go(); } }"
        val other = "class Robot { static void go() { } }"
        val graded = grade(
            file("c/mullercarl_late_4712_99888_Fahrt-1.java", java),
            file("c/mullercarl_late_4712_99889_Robot-1.java", other),
            file("c/meyeranna_4713_99890_Fahrt (1).java", java.replace("Robot.go();", "")),
            file("c/özil_4714_99891_U\u0308bung.java", java.replace("Fahrt", "Übung").replace("Robot.go();", "")),
        )
        assertEquals(List(3) { 4 }, graded.map { assertIs<GradedHandIn.Graded>(it, "$it").runs.size })
        assertEquals(
            listOf(listOf("Fahrt.java", "Robot.java"), listOf("Fahrt.java"), listOf("Übung.java")),
            graded.map { (it.submission as Submission.Usable).robot.programs.single().files.map { file -> file.name } },
        )
    }
}
