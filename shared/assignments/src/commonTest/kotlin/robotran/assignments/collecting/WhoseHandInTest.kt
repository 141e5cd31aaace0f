package robotran.assignments.collecting

import kotlinx.coroutines.test.runTest
import robotran.assignments.ASSIGNMENT
import robotran.assignments.DRAWS
import robotran.assignments.collect
import robotran.assignments.doing.pupilCopy
import robotran.assignments.file
import robotran.assignments.handIn
import robotran.assignments.robolang
import robotran.documents.ZipEntry
import robotran.documents.zipOf
import robotran.language.Language
import robotran.projects.AssignmentTries
import robotran.projects.Course
import robotran.projects.Feedback
import robotran.projects.LinkCreation
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.handInLinkOf
import robotran.projects.linkOf
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class WhoseHandInTest {
    private val given = robolang("forward 3\n", "start.robo")
    private val teachers = with(given)
    private val pupils = pupilCopy(teachers)

    /** The assignment with another program. */
    private fun with(vararg programs: ProjectProgram): Project =
        ASSIGNMENT.copy(robots = listOf(ProjectRobot(ASSIGNMENT.world.robots.first().name, programs.toList())))

    /** A pupil's work that was saved, and not handed in. */
    private fun work(text: String) = pupilCopy(with(robolang(text)))

    private fun zip(path: String, vararg files: CollectedFile) =
        CollectedFile(path, zipOf(files.map { ZipEntry(it.path, it.bytes) }))

    private fun names(found: List<Submission>) = found.map { it.name }

    private fun remarks(submission: Submission) = assertIs<Submission.Usable>(submission, "$submission").remarks

    private suspend fun collectAll(vararg files: CollectedFile) =
        collectHandIns(files.toList(), teachers, Language.ENGLISH)

    @Test
    fun `projects without a name have a row each, as programs have`() = runTest {
        val files = arrayOf(
            file("Ida.robo", DRAWS),
            file("Jan.robo", DRAWS),
            file("Lea.robotran", work("forward 1\n")),
            file("Mia.robotran", work("forward 2\n")),
            file("Nik.robotran", handIn(" ", listOf(robolang("forward 4\n")))),
            file("Ole.robotran", handIn("", listOf(robolang("forward 5\n")))),
        )
        val expected = listOf("Ida", "Jan", "Lea", "Mia", "Nik", "Ole")
        val inFolder = files.map { CollectedFile("subs/${it.path}", it.bytes) }.toTypedArray()
        assertEquals(expected, names(collect(*files)))
        assertEquals(expected, names(collect(*inFolder)))
        assertEquals(expected, names(collect(zip("class.zip", *files))))
        assertEquals(expected, names(collect(zip("class.zip", *inFolder))))
        assertEquals(expected, names(collect(zip("class.zip", *files.drop(1).toTypedArray()), files[0])))
        assertEquals(expected, names(collectAll(zip("class.zip", *files), file("maze.robotran", pupils)).submissions))
    }

    @Test
    fun `the assignment and feedback are no hand-ins`() = runTest {
        val answered = handIn("Ben").copy(feedback = Feedback("Well done."))
        val found = collectAll(
            file("subs/maze-pupil.robotran", pupils),
            file("subs/maze-teacher.robotran", teachers),
            file("subs/Ben.robotran", answered),
            file("subs/Lea.robotran", work("forward 1\n")),
            file("subs/Mia.robotran", pupils.copy(tries = AssignmentTries(2))),
        )
        assertEquals(listOf("Lea", "Mia"), names(found.submissions))
        assertEquals(
            listOf(
                "maze-pupil.robotran is the assignment itself, not a hand-in.",
                "maze-teacher.robotran is the assignment itself, not a hand-in.",
                "Ben.robotran is feedback, not a hand-in.",
            ),
            found.notes,
        )
        assertEquals(emptyList(), remarks(found.submissions[0]))
        assertEquals(listOf<SubmissionRemark>(SubmissionRemark.Unchanged), remarks(found.submissions[1]))
    }

    @Test
    fun `a link to the assignment is no hand-in`() = runTest {
        val ofAssignment =
            "https://school.example/" + assertIs<LinkCreation.Made>(linkOf(pupils, Language.ENGLISH)).fragment
        val found =
            collectAll(file("links.txt", "$ofAssignment\n${link(handIn("Eva"))}\n"), file("one.txt", ofAssignment))
        assertEquals(listOf("Eva"), names(found.submissions))
        assertEquals(
            listOf("links.txt, line 1", "one.txt").map { "$it is the assignment itself, not a hand-in." },
            found.notes,
        )
    }

    @Test
    fun `a link to a course gets its own reason`() = runTest {
        val ofCourse = assertIs<LinkCreation.Made>(
            linkOf(Course("Draw", assignments = listOf(pupils)), Language.ENGLISH),
        ).fragment
        val found = collect(file("course.txt", "https://school.example/$ofCourse")).single()
        assertEquals("It is a link to a course, without a program.", assertIs<Submission.Unusable>(found).reason)
    }

    @Test
    fun `in a pupil's folder an unused copy is a hand-in if there is nothing else`() = runTest {
        val answered = handIn("Eva").copy(feedback = Feedback("Well done."))
        val found = collectAll(
            file("subs/Ada_1_assignsubmission_file_/maze.robotran", pupils),
            file("subs/Ben_2_assignsubmission_file_/maze.robotran", pupils),
            file("subs/Ben_2_assignsubmission_file_/mine.robo", DRAWS),
            file("subs/cem/maze.robotran", pupils),
            file("subs/dora/prog.robo", "forward 3 \r\n\r\n"),
            file("subs/eva/old.robotran", answered),
        )
        assertEquals(listOf("Ada", "Ben", "cem", "dora", "eva"), names(found.submissions))
        val unchanged = listOf<SubmissionRemark>(SubmissionRemark.Unchanged)
        assertEquals(listOf(unchanged, emptyList(), unchanged, unchanged), found.submissions.take(4).map(::remarks))
        assertEquals(
            "old.robotran is feedback, not a hand-in.",
            assertIs<Submission.Unusable>(found.submissions[4]).reason,
        )
    }

    @Test
    fun `a pupil's folder says whose all in it is, and another name in a hand-in is told`() = runTest {
        val files = arrayOf(
            file("Ana Gil/Draw - Íñigo, 7.º B.robotran", handIn("Íñigo, 7.º B")),
            file("Eva Sol/x.robo", DRAWS),
            file("Jan Roth/a.robotran", handIn("Jan", tries = 2)),
            file("Jan Roth/b.robotran", handIn("Lea", tries = 1)),
        )
        val inFolder = files.map { CollectedFile("class/${it.path}", it.bytes) }.toTypedArray()
        for (found in listOf(collect(*files), collect(*inFolder), collect(zip("class.zip", *files)))) {
            assertEquals(listOf("Ana Gil", "Eva Sol", "Jan Roth"), names(found))
            val other = listOf<SubmissionRemark>(SubmissionRemark.OtherName("Íñigo, 7.º B"))
            assertEquals(listOf(other, emptyList()), found.take(2).map(::remarks))
            assertIs<SubmissionRemark.FewerTries>(remarks(found[2]).single())
        }
    }

    @Test
    fun `two pupils of the same name have two rows`() = runTest {
        val one = handIn("Anna", tries = 3)
        val found = collect(
            file("a.robotran", one),
            file("b.robotran", handIn(" anNA ", tries = 7)),
            file("copy of a.robotran", one),
            file("links.txt", "${link(handIn("Anna", tries = 4))}\n${link(one)}"),
            file("Ben.robo", DRAWS),
        )
        assertEquals(listOf("Anna", " anNA ", "Anna", "Ben"), names(found))
        assertEquals(listOf("a.robotran", "b.robotran", "links.txt, line 1", "Ben.robo"), found.map { it.origin })
        assertEquals(emptyList(), found.flatMap(::remarks))
    }

    @Test
    fun `the same hand-in of two pupils has two rows`() = runTest {
        val shared = handIn("Anna")
        val found = collect(file("subs/anna/a.robotran", shared), file("subs/ben/a.robotran", shared))
        assertEquals(listOf("subs/anna/a.robotran", "subs/ben/a.robotran"), found.map { it.origin })
    }

    private suspend fun link(project: Project): String =
        "https://school.example/" + assertIs<LinkCreation.Made>(handInLinkOf(project, Language.ENGLISH)).fragment
}
