package robotran.assignments.collecting

import kotlinx.coroutines.test.runTest
import robotran.assignments.ASSIGNMENT
import robotran.assignments.collect
import robotran.assignments.file
import robotran.assignments.handIn
import robotran.assignments.java
import robotran.assignments.robolang
import robotran.documents.ZipEntry
import robotran.documents.zipOf
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.toBytes
import robotran.projects.LinkCreation
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.projects.handInLinkOf
import robotran.projects.linkOf
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class CollectSubmissionsTest {
    private fun zip(path: String, vararg files: CollectedFile) =
        CollectedFile(path, zipOf(files.map { ZipEntry(it.path, it.bytes) }))

    private fun names(submissions: List<Submission>) = submissions.map { it.name }

    private fun programs(submission: Submission): List<String> =
        assertIs<Submission.Usable>(submission, "$submission").robot.programs.flatMap { program ->
            program.files.map { it.name }
        }

    private fun reason(submission: Submission): String = assertIs<Submission.Unusable>(submission).reason

    private fun remarks(submission: Submission) = assertIs<Submission.Usable>(submission).remarks

    private suspend fun link(project: Project, isHandIn: Boolean = true): String = "https://school.example/" +
        assertIs<LinkCreation.Made>(
            if (isHandIn) handInLinkOf(project, Language.ENGLISH) else linkOf(project, Language.ENGLISH),
        ).fragment

    @Test
    fun `each file of a folder is a pupil`() = runTest {
        val found = collect(
            file("subs/anna.robo", "beep\n"),
            file("subs/Ben.java", "class Ben { public static void main(String[] a) { } }"),
            file("subs/Cem.java", "class Cem { public static void main(String[] a) { } }"),
            file("subs/dora.robotran", handIn("Dora D.")),
        )
        assertEquals(listOf("anna", "Ben", "Cem", "Dora D."), names(found))
        assertEquals(listOf("anna.robo"), programs(found[0]))
        assertEquals(2, assertIs<Submission.Usable>(found[3]).handIn?.tries?.plus(1))
        assertEquals(emptyList(), found.flatMap(::remarks))
    }

    @Test
    fun `programs in NQC come with what they include, and images as assembly text`() = runTest {
        val image = RcxImage(FirmwareTarget.RCX2, listOf(Chunk(ChunkId.MAIN, CodeBytes.of(0x50))))
        val found = collect(
            file("subs/anna.nqc", "#include \"moves.nqh\"\ntask main() { go(); }"),
            file("subs/moves.nqh", "void go() { }"),
            CollectedFile("subs/ben.rcx", image.toBytes()),
            file("subs/cem.lasm", "\ttask 0\n\tendt\n"),
            file("subs/dora.rcx", "no image"),
        )
        assertEquals(listOf("anna", "ben", "cem", "dora"), names(found))
        assertEquals(listOf("anna.nqc", "moves.nqh"), programs(found[0]))
        assertEquals(listOf("ben.lasm"), programs(found[1]))
        assertTrue(reason(found[3]).startsWith("dora.rcx: "), reason(found[3]))
    }

    @Test
    fun `each folder of a folder is a pupil`() = runTest {
        val found = collect(
            file("subs/anna/prog.robo", "beep\n"),
            file("subs/anna/notes.pdf", "%PDF"),
            file("subs/ben/src/Main.java", "class Main { public static void main(String[] a) { } }"),
            file("subs/ben/src/Arm.java", "class Arm { }"),
            file("subs/cem/one.robo", "beep\n"),
            file("subs/cem/two.robo", "buzz\n"),
        )
        assertEquals(listOf("anna", "ben", "cem"), names(found))
        assertEquals(listOf("Main.java", "Arm.java"), programs(found[1]))
        assertEquals(listOf("one.robo", "two.robo"), programs(found[2]))
        assertEquals("subs/ben", found[1].origin)
    }

    @Test
    fun `Java files of one folder are one program`() = runTest {
        val found =
            collect(
                file("maze/Arm.java", "class Arm { }"),
                file("maze/Go.java", "class Go { static void main(String[] a) { } }"),
            )
        assertEquals(listOf("maze"), names(found))
        assertEquals(listOf("Go.java", "Arm.java"), programs(found.single()))
    }

    @Test
    fun `folders of classes hold folders of pupils`() = runTest {
        val found = collect(
            file("8a/anna/Go.java", "class Go { static void main(String[] a) { } }"),
            file("8a/ben/Go.java", "class Go { static void main(String[] a) { } }"),
            file("8b/anna/go.robo", "beep\n"),
            file("8b/cem/go.robo", "beep\n"),
        )
        assertEquals(listOf("8a/anna", "8a/ben", "8b/anna", "8b/cem"), names(found))
    }

    @Test
    fun `learning platforms tell the names of pupils`() = runTest {
        val found = collect(
            file("t/Anna Meyer_12345_assignsubmission_file_/prog.robo", "beep\n"),
            file("t/Anna Meyer_12399_assignsubmission_file_/prog.robo", "buzz\n"),
            file("t/Ben Özil_12346_assignsubmission_file_Go.java", "class Go { }"),
            file("t/Ben Özil_12346_assignsubmission_file_Arm.java", "class Arm { }"),
            file("t/cemali_12347_67890_go.robo", "beep\n"),
            file("t/dorad_LATE_12348_67891_x.robotran", handIn("D.")),
            file("t/Eva_12349_assignsubmission_onlinetext_/onlinetext.html", "<p>${link(handIn("Eve"))}</p>"),
            file("t/Fay_12350_assignsubmission_file_/essay.docx", "PK"),
        )
        val platform = listOf("Anna Meyer", "Anna Meyer", "Ben Özil", "cemali", "dorad", "Eva", "Fay")
        assertEquals(platform, names(found))
        assertEquals(listOf("Arm.java", "Go.java"), programs(found[2]))
        assertEquals("There is no program, no project and no link in it.", reason(found[6]))
    }

    @Test
    fun `zips are folders, also inside each other`() = runTest {
        val found = collect(
            zip(
                "subs.zip",
                zip("Anna_1_assignsubmission_file_/work.zip", file("my work/prog.robo", "beep\n")),
                zip("Ben_2_assignsubmission_file_work.zip", file("prog.robo", "beep\n")),
                file("cem.robotran", handIn("Cem")),
                file("__MACOSX/._cem.robotran", "junk"),
                file(".DS_Store", "junk"),
                file("Thumbs.db", "junk"),
            ),
        )
        assertEquals(listOf("Anna", "Ben", "Cem"), names(found))
        assertEquals(listOf("prog.robo"), programs(found[0]))
    }

    @Test
    fun `a text has one link per line`() = runTest {
        val plain = Project(BuiltInWorlds.plain, listOf(ProjectRobot("robot", listOf(robolang("beep\n")))))
        val robot = BuiltInWorlds.plain.robots.first().name
        val project = plain.copy(robots = listOf(plain.robots.single().copy(name = robot)))
        val broken = link(handIn("Cem")).dropLast(5)
        val found = collect(
            file(
                "links.txt",
                "Here they are:\r\n${link(
                    handIn("Anna"),
                )}\r\n\r\n${link(project, isHandIn = false)}\n$broken\n#w=aAAAA",
            ),
            file("one.url", "[InternetShortcut]\nURL=${link(handIn("Dora"), isHandIn = false)}\n"),
        )
        assertEquals(
            listOf("Anna", "links.txt, line 4", "links.txt, line 5", "links.txt, line 6", "Dora"),
            names(found),
        )
        assertEquals(emptyList(), remarks(found[0]))
        assertTrue(reason(found[2]).startsWith("The link is broken"), reason(found[2]))
        assertEquals(ASSIGNMENT.world, assertIs<Submission.Usable>(found[0]).project?.world)
    }

    @Test
    fun `of several hand-ins of a pupil the one with most tries counts`() = runTest {
        val found = collect(
            file("anna/a.robotran", handIn("Anna", tries = 3)),
            file("anna/b.robotran", handIn(" anNA ", tries = 7)),
            file("anna/c.robotran", handIn("Anna", tries = 2)),
            file("ben/x.robotran", handIn("Ben")),
        )
        assertEquals(listOf("anna", "ben"), names(found))
        assertEquals(7, assertIs<Submission.Usable>(found[0]).handIn?.tries)
        val others = listOf("anna/a.robotran", "anna/c.robotran")
        assertEquals(listOf<SubmissionRemark>(SubmissionRemark.FewerTries(others)), remarks(found[0]))
    }

    @Test
    fun `a world whose goals say the same in another language has not been changed`() = runTest {
        val goals = ASSIGNMENT.world.goals.map { it.copy(says = "Zeichne mindestens 10 cm.") }
        val german = ASSIGNMENT.copy(world = ASSIGNMENT.world.copy(title = "Zeichne", goals = goals))
        val found = collect(file("a.robotran", handIn("Anna", assignment = german)))
        assertEquals(emptyList(), remarks(found.single()))
    }

    @Test
    fun `remarks tell what was changed or is not allowed`() = runTest {
        val rules = checkNotNull(ASSIGNMENT.assignment)
            .copy(languages = listOf(ProgramLanguage.ROBOLANG), words = listOf("Forward", "pen"))
        val strict = ASSIGNMENT.copy(assignment = rules)
        val honest = handIn("Anna")
        val other = handIn("Cem", assignment = ASSIGNMENT.copy(assignment = rules.copy(id = "other")))
        val smaller = ASSIGNMENT.copy(world = ASSIGNMENT.world.copy(title = "Other", goals = emptyList()))
        val found = collect(
            file("a.robotran", honest),
            file("b.robotran", honest.copy(handIn = honest.handIn?.copy(name = "Ben"))),
            file("c.robotran", other),
            file("d.robotran", handIn("Dora", assignment = smaller)),
            file("e.robotran", handIn("Eva", listOf(robolang("BEEP // buzz\nshow abs(3)\n"), java("class A {}")))),
            assignment = strict,
        )
        assertEquals(emptyList(), remarks(found[0]))
        assertEquals(listOf<SubmissionRemark>(SubmissionRemark.Changed), remarks(found[1]))
        assertEquals("It was handed in for another assignment: Draw.", reason(found[2]))
        assertEquals(listOf<SubmissionRemark>(SubmissionRemark.WorldChanged), remarks(found[3]))
        assertEquals(
            listOf(
                SubmissionRemark.LanguageNotAllowed("Prog.java"),
                SubmissionRemark.WordsNotAllowed(listOf("beep", "show", "abs")),
                SubmissionRemark.ChosenInApp("prog.robo", listOf("prog.robo", "Prog.java")),
            ),
            remarks(found[4]),
        )
    }

    @Test
    fun `what cannot be used is a row with a reason`() = runTest {
        val bomb = ByteArray(CollectingLimits.MAXIMUM_INNER_ZIP_BYTES + 1)
        val deep = zip("1.zip", zip("2.zip", zip("3.zip", zip("4.zip", file("deep.robo", "beep\n")))))
        val found = collect(
            zip("bomb.zip", CollectedFile("inner.zip", bomb)),
            file("good.robo", "beep\n"),
            CollectedFile("broken.zip", byteArrayOf(1, 2, 3)),
            CollectedFile("latin.robo", byteArrayOf(0x62, 0xE4.toByte())),
            CollectedFile("binary.robo", byteArrayOf(0x62, 0, 0xE4.toByte())),
            file("karl.robo.txt", "beep\n"),
            file("newer.robotran", """{"format": "robotran-project", "version": 99}"""),
            file("plain.robotran", Project(BuiltInWorlds.plain)),
            file("long.robo", "a".repeat(200_001)),
            file("photo.jpg", "JFIF"),
            file("six/a.robo", "show 97"),
            file("six/b.robo", "show 98"),
            file("six/c.robo", "show 99"),
            file("six/d.robo", "show 100"),
            file("six/e.robo", "show 101"),
            file("six/f.robo", "show 102"),
            deep,
        )
        val reasons = found.associate { it.name to (it as? Submission.Unusable)?.reason.orEmpty() }
        assertEquals("", reasons["good"])
        assertTrue("inner.zip is too large" in reasons.getValue("bomb"), "$reasons")
        assertEquals("broken.zip is damaged, or not a zip file at all.", reasons["broken"])
        assertEquals("", reasons["latin"])
        assertEquals("", reasons["karl"])
        assertEquals("binary.robo is not a text.", reasons["binary"])
        assertTrue("newer Robotran" in reasons.getValue("newer"), "$reasons")
        assertTrue("no program for its robot" in reasons.getValue("plain"), "$reasons")
        assertTrue("too long" in reasons.getValue("long"), "$reasons")
        assertEquals("There is no program, no project and no link in it.", reasons["photo"])
        assertEquals("It has 6 programs, but a brick has room for 5.", reasons["six"])
        assertTrue("too many zip files" in reasons.getValue("1"), "$reasons")
    }

    @Test
    fun `more than the most become one row`() = runTest {
        val files = List(503) { file("p$it.robo", "beep\n") }
        val found = collect(*files.toTypedArray())
        assertEquals(501, found.size)
        assertEquals("3 more were left out: 500 hand-ins can be looked at together.", reason(found.last()))
    }
}
