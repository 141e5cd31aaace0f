package robotran.assignments.collecting

import kotlinx.coroutines.test.runTest
import robotran.assignments.ASSIGNMENT
import robotran.assignments.DRAWS
import robotran.assignments.collect
import robotran.assignments.file
import robotran.assignments.handIn
import robotran.assignments.robolang
import robotran.documents.ZipEntry
import robotran.documents.zipOf
import robotran.language.Language
import robotran.projects.ProjectRobot
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** What has no program, or is not what it seems. */
class ForgottenHandInsTest {
    private val long = DRAWS + "repeat 3 times\n  turn left 90\n  forward 2\n  beep\nend\nbackward 3\n"
    private val solved = ASSIGNMENT.copy(
        assignment = checkNotNull(ASSIGNMENT.assignment).copy(solution = listOf(robolang(long, "best.robo"))),
    )

    private fun remarks(submission: Submission) = submission.remarks

    @Test
    fun `an empty folder of a pupil is a row, in a folder and in a zip`() = runTest {
        val files = listOf(
            file("class/anna/", ""),
            file("class/ben/prog.robo", DRAWS),
            file("class/cem/.DS_Store", ""),
            file("class/dora/README.TXT", "made with BlueJ"),
        )
        val zip = CollectedFile("class.zip", zipOf(files.map { ZipEntry(it.path, it.bytes) }))
        val inZip = CollectedFile("moodle.zip", zipOf(listOf(ZipEntry("Eva_1_assignsubmission_file_/", ByteArray(0)))))
        assertEquals(
            listOf("ben: ok", "anna: The folder is empty.", "dora: The folder is empty."),
            collect(*files.toTypedArray()).map(::described),
        )
        assertEquals(setOf("ben", "anna", "dora"), collect(zip).map { it.name }.toSet())
        assertEquals(listOf("Eva: The folder is empty."), collect(inZip).map(::described))
        assertEquals(listOf("ben: The folder is empty."), collect(file("ben/", "")).map(::described))
        assertEquals(listOf("ben: The folder is empty."), collect(file("class/ben/", "")).map(::described))
    }

    @Test
    fun `what editors leave behind makes no row, and compiled classes do not count beside their source`() = runTest {
        val java = "public class Go { public static void main(String[] a) { } }"
        val found = collect(
            file("class/Go.java", java),
            file("class/Go.class", "old"),
            file("class/Go\$1.class", "old"),
            file("class/Go.ctxt", ""),
            file("class/package.bluej", ""),
            file("class/README.TXT", "read me"),
            file("class/~\$liste.docx", ""),
            file("class/Ida.robo", DRAWS),
        )
        assertEquals(listOf("Go: ok", "Ida: ok"), found.map(::described))
        val classes = SubmissionRemark.CompiledLeftOut(listOf("Go.class", "Go\$1.class"))
        assertEquals(listOf<SubmissionRemark>(classes), remarks(found[0]))
        val alone = collect(file("class/anna/Go.class", "old"), file("class/ben/prog.robo", DRAWS))
        assertEquals("anna: There are only compiled classes in it. Ask for the Java files.", described(alone[0]))
    }

    @Test
    fun `a hand-in from somebody else is told`() = runTest {
        val names = listOf(
            "Oezdemir Ali" to "Ali",
            "Özdemir Ali" to "oezdemir",
            "meyeranna" to "Anna M.",
            "Zorn Jo" to "7b",
        )
        val others = listOf("Oezdemir Ali" to "Jörg, 7b", "Anna" to "Ben")
        val files = (names + others).mapIndexed { index, (folder, entered) ->
            file("m/${folder}_10${index}_assignsubmission_file_/x.robotran", handIn(entered, tries = index))
        }
        val found = collect(*files.toTypedArray())
        assertEquals((names + others).map { it.first }, found.map { it.name })
        val described = others.map { listOf<SubmissionRemark>(SubmissionRemark.OtherName(it.second)) }
        assertEquals(names.map { emptyList<SubmissionRemark>() } + described, found.map(::remarks))
        val plain = collect(file("c/Ben/x.robotran", handIn("Anna")), file("c/Cem/x.robo", DRAWS))
        assertEquals(listOf<SubmissionRemark>(SubmissionRemark.OtherName("Anna")), remarks(plain[0]))
    }

    @Test
    fun `a folder with the hand-ins of several pupils is called after none of them`() = runTest {
        val found = collect(
            file("c/7b/x.robotran", handIn("Anna")),
            file("c/group one/y.robotran", handIn("Ben")),
            file("c/group one/z.robotran", handIn("Cem")),
        )
        assertEquals(listOf("Anna", "Ben", "Cem"), found.map { it.name })
        assertEquals(emptyList(), found.flatMap(::remarks))
    }

    @Test
    fun `a program that equals the solution is told, whatever its names and blanks`() = runTest {
        val copied = long.replace("  ", "    ").replace("beep", "beep // mine")
        val found = collect(
            file("a.robo", copied),
            file("b.robo", "$long\nbuzz\nshow 3\n"),
            assignment = solved,
        )
        assertEquals(listOf(listOf<SubmissionRemark>(SubmissionRemark.IsSolution), emptyList()), found.map(::remarks))
        val short = solved.copy(
            assignment = solved.assignment?.copy(solution = listOf(robolang(DRAWS))),
        )
        assertEquals(emptyList(), remarks(collect(file("a.robo", DRAWS), assignment = short).single()))
    }

    @Test
    fun `the teacher's own file in a pupil's folder is told`() = runTest {
        val robot = ProjectRobot(ASSIGNMENT.world.robots.first().name, listOf(robolang("beep\n")))
        val teachers = solved.copy(robots = listOf(robot))
        val found = collect(
            file("m/Vera_1_assignsubmission_file_/maze.robotran", teachers),
            file("m/Wim_2_assignsubmission_file_/a.robo", DRAWS),
            assignment = teachers,
        )
        assertEquals(listOf("Vera: ok", "Wim: ok"), found.map(::described))
        assertEquals(SubmissionRemark.TeachersFile, remarks(found[0]).first())
    }

    @Test
    fun `the teacher's file of another assignment is only told as that`() = runTest {
        val other = ASSIGNMENT.copy(assignment = ASSIGNMENT.assignment?.copy(id = "other"))
        val found = collect(file("c/vera/maze.robotran", other), file("c/wim/a.robo", DRAWS))
        assertEquals("vera: It was handed in for another assignment: Draw.", described(found[0]))
        assertEquals(emptyList(), remarks(found[0]))
    }

    @Test
    fun `what lies beside a hand-in is told`() = runTest {
        val found = collect(
            file("c/ida/x.robotran", handIn("Ida")),
            file("c/ida/alt.robo", "beep\n"),
            file("c/ida/newer.robotran", """{"format": "robotran-project", "version": 99}"""),
            file("c/jan/x.robo", DRAWS),
        )
        val (beside, part) = remarks(found[0])
        assertEquals(SubmissionRemark.BesideProject(listOf("alt.robo")), beside)
        assertEquals("newer.robotran: ", assertIs<SubmissionRemark.PartUnusable>(part).reason.take(16))
    }

    @Test
    fun `names stand where people look for them`() {
        val names = listOf("Zorn", "Özdemir", "Oz", "O\u0308del", "nz", "ña", "Ärmel", "arm")
        val sorted = { language: Language -> names.sortedBy { sortKey(it, language) }.map(::composed) }
        assertEquals(listOf("arm", "Ärmel", "ña", "nz", "Ödel", "Oz", "Özdemir", "Zorn"), sorted(Language.GERMAN))
        assertEquals(listOf("arm", "Ärmel", "nz", "ña", "Ödel", "Oz", "Özdemir", "Zorn"), sorted(Language.SPANISH))
    }

    private fun described(submission: Submission): String = when (submission) {
        is Submission.Unusable -> "${submission.name}: ${submission.reason}"
        is Submission.Usable -> "${submission.name}: ok"
    }
}
