package robotran.documents

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.toBytes
import robotran.projects.LinkCreation
import robotran.projects.linkOf
import robotran.projects.writeProject
import robotran.world.ReadyRobots
import robotran.world.file.BuiltInWorlds
import robotran.world.file.writeRobot
import robotran.world.file.writeWorld
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class OpenFilesTest {
    private val world = BuiltInWorlds.plain.copy(title = "Town")

    @Test
    fun `a project is opened with the name of its file and where it was`() = runTest {
        val place = FileReference("/home/ann/Maze 2.robotran", "Maze 2.robotran")
        val bytes = writeProject(projectOf("beep")).encodeToByteArray()
        val opened = opened(IncomingFile(place.name, bytes, place))
        assertEquals(
            listOf(OpenedProject("Maze 2", projectOf("beep"), SaveTarget(place, FileStamp.of(bytes)))),
            opened.projects,
        )
    }

    @Test
    fun `a world and programs come together`() = runTest {
        val opened = opened(
            file("town.world.json", writeWorld(world)),
            file("a.robo", "beep"),
            file("B.java", "class B {}"),
            file("C.java", "class C {}"),
        )
        assertEquals("Town", opened.world?.title)
        assertEquals(listOf("a.robo", "B.java"), opened.programs.map { it.name })
        assertEquals(ProgramLanguage.JAVA, opened.programs.last().language)
        assertEquals(listOf("B.java", "C.java"), opened.programs.last().files.map { it.name })
    }

    @Test
    fun `a program in NQC comes with what it includes, and an image as assembly text`() = runTest {
        val image = RcxImage(FirmwareTarget.RCX2, listOf(Chunk(ChunkId.MAIN, CodeBytes.of(0x50))))
        val programs = opened(
            file("moves.nqh", "void go() { }"),
            file("a.nqc", "#include \"moves.nqh\"\ntask main() { go(); }"),
            file("b.lasm", "\ttask 0\n\tendt\n"),
            IncomingFile("c.rcx", image.toBytes()),
        ).programs.sortedBy { it.name }
        assertEquals(listOf("a.nqc", "b.lasm", "c.lasm"), programs.map { it.name })
        assertEquals(listOf("a.nqc", "moves.nqh"), programs.first().files.map { it.name })
        assertEquals(
            listOf(ProgramLanguage.NQC, ProgramLanguage.LASM, ProgramLanguage.LASM),
            programs.map { it.language },
        )
        val error = assertIs<OpenFilesError.InFile>(refused(file("d.rcx", "no image")))
        assertTrue(error.message.endsWith("."), error.message)
    }

    @Test
    fun `a robot comes alone or with a world`() = runTest {
        val sumo = writeRobot(ReadyRobots.SUMO)
        val alone = opened(file("sumo.robot.json", sumo))
        assertEquals(ReadyRobots.SUMO, alone.robot)
        assertEquals(null, alone.world)
        assertEquals(ReadyRobots.SUMO, opened(file("sumo (1).json.txt", "\uFEFF$sumo")).robot)
        val both = opened(file("sumo.robot.json", sumo), file("town.world.json", writeWorld(world)))
        assertEquals(ReadyRobots.SUMO to "Town", both.robot to both.world?.title)
    }

    @Test
    fun `a world stays a world, whatever it is called and whatever robots it has`() = runTest {
        val withSumo = world.copy(
            task = "Say \"robotran-robot\".",
            robots = world.robots.map { it.copy(description = ReadyRobots.SUMO) },
        )
        assertEquals(withSumo, opened(file("town.robot.json", writeWorld(withSumo))).world)
    }

    @Test
    fun `a robot that is none is refused in a sentence`() = runTest {
        val sumo = writeRobot(ReadyRobots.SUMO)
        val broken = listOf(
            "{}",
            "{",
            "null",
            "[".repeat(100_000),
            sumo.replace("robotran-robot", "robotran-rocket"),
            sumo.replaceFirst("\"title\"", "\"titel\""),
            "{\"format\": \"robotran-robot\", \"version\": 1, \"title\": \"x\", \"mass\": 1e999}",
            "{\"format\": \"robotran-robot\", \"version\": 99, \"title\": \"x\"}",
        )
        for (text in broken) {
            val error = assertIs<OpenFilesError.InFile>(refused(file("sumo.robot.json", text)), text.take(80))
            assertEquals("sumo.robot.json", error.file)
            assertTrue(error.message.length in 10..300, error.message)
        }
        assertEquals(
            OpenFilesError.SeveralRobots,
            refused(file("a.robot.json", sumo), file("b.robot.json", sumo)),
        )
    }

    @Test
    fun `files are known by what is in them when their names were changed on the way`() = runTest {
        assertEquals("Town", opened(file("town.world (1).json", writeWorld(world))).world?.title)
        assertEquals(
            "maze",
            opened(file("maze.robotran.txt", "\uFEFF" + writeProject(projectOf("beep")))).projects.single().name,
        )
    }

    @Test
    fun `a text with a link in it opens what is behind the link`() = runTest {
        val fragment = assertIs<LinkCreation.Made>(
            linkOf(projectOf("beep").copy(world = world), Language.ENGLISH),
        ).fragment
        assertEquals(
            "Town",
            opened(file("link.txt", "https://school.example/robotran/$fragment\n")).projects.single().name,
        )
        assertEquals(
            "Town",
            assertIs<OpenFilesResult.Success>(openLinkText(fragment, Language.ENGLISH)).projects.single().name,
        )
    }

    @Test
    fun `old programs in NQC are in the encoding of Windows`() = runTest {
        val words = "f\u00FCr Mar\u00EDa \u201Cok\u201D \u20AC"
        val bytes = words.map { (CODES[it] ?: it.code).toByte() }.toByteArray()
        for (name in listOf("old.nqc", "OLD.NQC")) {
            assertEquals(words, opened(IncomingFile(name, bytes)).programs.single().files.single().text)
        }
        val program = opened(file("main.nqc", "#include \"old.nqh\"\n"), IncomingFile("old.nqh", bytes))
        assertEquals(words, program.programs.single().files.last().text)
        assertEquals(OpenFilesError.NotText("x.nqc"), refused(IncomingFile("x.nqc", byteArrayOf(-1, 0, 3))))
    }

    @Test
    fun `programs in every language are read in old encodings and with other names, with a remark`() = runTest {
        val text = "// gr\u00FC\u00DF\n"
        val old = text.map { it.code.toByte() }.toByteArray()
        val wide = "\uFEFF$text".flatMap { listOf((it.code % 256).toByte(), (it.code / 256).toByte()) }.toByteArray()
        for (extension in listOf(".robo", ".java", ".nqc", ".lasm")) {
            for ((bytes, encoding) in listOf(old to "Windows-1252", wide to "UTF-16")) {
                val opened = opened(IncomingFile("Karl$extension", bytes))
                assertEquals(text, opened.programs.single().files.single().text)
                assertEquals(
                    listOf("Karl$extension is in $encoding, not in UTF-8. It was read all the same."),
                    opened.notes,
                )
            }
            for (name in listOf("Karl$extension.txt", "Karl${extension.uppercase()}", "Karl$extension.TXT")) {
                val opened = opened(file(name, text))
                assertEquals("Karl$extension", opened.programs.single().files.single().name)
                assertEquals(listOf("$name was read as Karl$extension."), opened.notes)
            }
            assertEquals(emptyList(), opened(file("Karl$extension", text)).notes)
        }
    }

    @Test
    fun `a misspelt field of a world, a robot, a project or a course is a remark`() = runTest {
        val text = writeWorld(world).replaceFirst("\"paper\"", "\"tsk\": \"Go.\", \"paper\"")
        val note = opened(file("town.world.json", text)).notes.single()
        assertTrue(note.startsWith("town.world.json: Line ") && "\"task\"" in note, note)
    }

    @Test
    fun `what cannot be used is refused with the file and why`() = runTest {
        assertEquals(OpenFilesError.UnknownKind("cat.png"), refused(file("cat.png", "meow")))
        assertEquals(OpenFilesError.NotText("a.robo"), refused(IncomingFile("a.robo", byteArrayOf(-1, 0, 3))))
        assertEquals(OpenFilesError.NotText("A.java"), refused(IncomingFile("A.java", byteArrayOf(-1, 0, 3))))
        assertEquals(OpenFilesError.TooLong("a.robo"), refused(file("a.robo", "\n".repeat(60_000))))
        val worlds = Array(2) { file("$it.world.json", writeWorld(world)) }
        assertEquals(OpenFilesError.SeveralWorlds, refused(*worlds))
        assertEquals(OpenFilesError.TooManyPrograms(5), refused(*Array(6) { file("a$it.robo", "beep") }))
        assertIs<OpenFilesError.InLink>(
            assertIs<OpenFilesResult.Failure>(openLinkText("#p=a???", Language.ENGLISH)).error,
        )
    }

    @Test
    fun `a broken file is refused with its line`() = runTest {
        val broken = writeWorld(world).replaceFirst("\"width\"", "\"breadth\"")
        val error = assertIs<OpenFilesError.InFile>(refused(file("a.robo", "beep"), file("town.world.json", broken)))
        assertEquals("town.world.json", error.file)
        assertContains(error.message, Regex("Line \\d+: paper.width is missing"))
    }

    @Test
    fun `names of works and files are what every system takes`() {
        assertEquals("Maze", validProjectName("  Maze\n"))
        assertEquals("Maze 🤖", validProjectName("Maze 🤖\uD83E"))
        assertEquals(
            "x".repeat(SavedProject.MAXIMUM_NAME - 1),
            validProjectName("x".repeat(SavedProject.MAXIMUM_NAME - 1) + "🤖"),
        )
        assertEquals(null, validProjectName(" \t"))
        assertEquals(SavedProject.MAXIMUM_NAME, validProjectName("x".repeat(500))?.length)
        assertEquals("Maze", projectNameOfFile("Maze.robotran"))
        assertEquals("Ann-s-Maze-.robotran", fileNameFor("Ann:s/Maze?", FileKind.PROJECT))
        assertEquals("robotran.robotran", fileNameFor(" .. ", FileKind.PROJECT))
        assertEquals("square.png", fileNameFor("square.robo", FileKind.PNG))
    }

    private fun file(name: String, text: String) = IncomingFile(name, text.encodeToByteArray())

    private suspend fun opened(vararg files: IncomingFile) =
        assertIs<OpenFilesResult.Success>(openFiles(files.toList(), Language.ENGLISH))

    private suspend fun refused(vararg files: IncomingFile) =
        assertIs<OpenFilesResult.Failure>(openFiles(files.toList(), Language.ENGLISH)).error

    private companion object {
        /** Quotation marks and the euro in Windows-1252. */
        val CODES = mapOf('\u201C' to 0x93, '\u201D' to 0x94, '\u20AC' to 0x80)
    }
}
