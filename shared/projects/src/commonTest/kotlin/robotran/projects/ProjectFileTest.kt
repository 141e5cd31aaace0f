package robotran.projects

import robotran.brick.program.ProgramRun
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.toBytes
import robotran.programs.Program
import robotran.programs.ProgramSource
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom
import robotran.simulation.RecordedInput
import robotran.simulation.SessionInput
import robotran.world.geometry.Pose
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class ProjectFileTest {
    @Test
    fun `a project is read as it was written`() {
        assertEquals(FULL_PROJECT, loaded(writeProject(FULL_PROJECT)))
        val min = Project(FULL_PROJECT.world)
        assertEquals(min, loaded(writeProject(min)))
    }

    @Test
    fun `a file has only what happened before a program was sent to run at once`() {
        val program = object : RcxProgram {
            override val name = "now"

            override fun start(rom: Rom): ProgramRun = error("It does not run.")
        }
        val (first, second) = FULL_PROJECT.inputs
        val sent = RecordedInput(second.milliseconds, SessionInput.RunSnippet(program))
        val project = FULL_PROJECT.copy(inputs = listOf(first, sent, second))
        assertEquals(listOf(first), loaded(writeProject(project)).inputs)
    }

    @Test
    fun `the example of the page on projects can be read and is written as it stands there`() {
        val text = documentedProjects.values.single()
        val project = loaded(text)
        assertEquals(listOf("square.robo", "Main.java"), project.robots.single().programs.map { it.name })
        assertEquals(project, loaded(writeProject(project)))
        assertTrue(text.substringBefore("  \"world\"") in writeProject(project), writeProject(project))
    }

    @Test
    fun `programs are told as their reader takes them`() {
        val a = Program("a.robo", ProgramLanguage.ROBOLANG, "beep\r\n\tbuzz // ñ🤖\u0000\n")
        val b =
            Program("B", ProgramLanguage.JAVA, listOf(SourceFile("B.java", "class B {\n}"), SourceFile("C.java", "")))
        assertEquals(mapOf("bob" to listOf(a, b), "ann" to emptyList()), FULL_PROJECT.programs)
        assertEquals(FULL_PROJECT.robots.first().programs, listOf(a, b).map { ProjectProgram.of(it) })
        assertNull(ProjectProgram.of(ProgramSource.CompiledClasses("C", emptyMap())))
    }

    @Test
    fun `programs for LEGO's firmware keep their files, and an image becomes assembly text`() {
        assertEquals(FIRMWARE_PROJECT, loaded(writeProject(FIRMWARE_PROJECT)))
        val (nqc, lasm) = FIRMWARE_PROJECT.programs.values.single()
        assertEquals(listOf("d.nqc", "e.nqh"), assertIs<Program>(nqc).files.map { it.name })
        assertEquals("\ttask 0\n\tendt\n", assertIs<Program>(lasm).text)
        val image = RcxImage(FirmwareTarget.RCX2, listOf(Chunk(ChunkId.MAIN, CodeBytes.of(STOP))))
        val program = assertNotNull(ProjectProgram.of(ProgramSource.FirmwareImage("f.rcx", image.toBytes())))
        assertEquals(ProgramLanguage.LASM to "f.lasm", program.language to program.name)
        assertContains(program.files.single().text, "\tstop")
        assertNull(ProjectProgram.of(ProgramSource.FirmwareImage("f.rcx", byteArrayOf())))
    }

    @Test
    fun `a program comes in the view that its file says, and in the reader's own if that says none`() {
        val view = { text: String -> loaded(text).robots.first().programs.first().view }
        val plain = writeProject(FULL_PROJECT)
        assertNull(view(plain))
        for (each in ProgramView.entries) {
            val written = plain.replaceFirst("\"robolang\"", "\"robolang\", \"view\": \"${each.name.lowercase()}\"")
            assertEquals(each, view(written))
            assertEquals(
                written.filterNot { it.isWhitespace() },
                writeProject(loaded(written)).filterNot { it.isWhitespace() },
            )
        }
    }

    @Test
    fun `a view that this Robotran does not know is no mistake, and neither is one of a Java program`() {
        val plain = writeProject(FULL_PROJECT)
        for (unknown in listOf("\"flowchart\"", "5", "null", "{}")) {
            val written = plain.replaceFirst("\"robolang\"", "\"robolang\", \"view\": $unknown")
            assertNull(loaded(written).robots.first().programs.first().view, unknown)
        }
        val java = plain.replaceFirst("\"java\"", "\"java\", \"view\": \"blocks\"")
        assertNull(loaded(java).robots.first().programs[1].view)
    }

    @Test
    fun `settings take the place of what the world says`() {
        assertEquals(5, FULL_PROJECT.worldToRun.seed)
        assertEquals(0.25, FULL_PROJECT.worldToRun.realism)
        assertEquals(FULL_PROJECT.world, Project(FULL_PROJECT.world).worldToRun)
    }

    @Test
    fun `what is done to something that is not there is left out`() {
        val inputs = FULL_PROJECT.inputs.map { it.copy(input = SessionInput.SwitchLamp(2, true)) } +
            RecordedInput(6_000_000, SessionInput.PlaceBlock(2, Pose(0.0, 0.0, 0.0)))
        assertEquals(FULL_PROJECT.copy(inputs = emptyList()), loaded(writeProject(FULL_PROJECT.copy(inputs = inputs))))
    }

    @Test
    fun `unknown fields are kept`() {
        val text = writeProject(FULL_PROJECT)
            .replaceFirst("\"seed\": 5", "\"seed\": 5, \"luck\": 1.0")
            .replaceFirst("\"speed\": ", "\"heap\": 4, \"speed\": ")
            .replaceFirst("\"firstProgram\"", "\"hat\": null, \"firstProgram\"")
            .replaceFirst("\"language\"", "\"read\": true, \"language\"")
            .replaceFirst("\"world\": {", "\"by\": \"me\", \"world\": { \"of\": \"me\", ")
        val written = writeProject(loaded(text))
        assertEquals(loaded(text), loaded(written))
        listOf(
            "\"luck\": 1.0",
            "\"heap\": 4",
            "\"hat\": null",
            "\"read\": true",
            "\"by\": \"me\"",
            "\"of\": \"me\"",
        ).forEach {
            assertTrue(it in written, "$it is in\n$written")
        }
    }

    @Test
    fun `what is no project is refused`() {
        val refusal = { text: String ->
            assertIs<ProjectFileResult.Failure>(readProject(text, Language.ENGLISH)).message
        }
        assertEquals(
            "This is not a Robotran project: a project file says \"format\": \"robotran-project\".",
            refusal("{}"),
        )
        assertEquals("Line 1: version is missing.", refusal("{\"format\": \"robotran-project\"}"))
        assertEquals(
            "Line 1: This project was made by a newer Robotran (it has version 2, this Robotran reads up to 1).",
            refusal("{\"format\": \"robotran-project\", \"version\": 2}"),
        )
        assertEquals(
            "The file is not a text.",
            assertIs<ProjectFileResult.Failure>(readProject(byteArrayOf(0, -1, 3), Language.ENGLISH)).message,
        )
    }

    @Test
    fun `a refusal tells path and line, also in the world`() {
        val text = writeProject(FULL_PROJECT).replaceFirst("\"thickness\": 1 ", "\"thickness\": 0 ")
        val line = text.substringBefore("\"thickness\": 0").count { it == '\n' } + 1
        assertEquals(
            ProjectFileResult.Failure(
                "Line $line: world.walls[0].thickness must be from 0.1 to 100.",
                line,
                "world.walls[0].thickness",
            ),
            readProject(text, Language.ENGLISH),
        )
    }

    @Test
    fun `values that are not allowed are refused with their place`() {
        assertEquals("robots[0].name must be the name of a robot of the world.", refusalWith("\"bob\"", "\"bo\""))
        assertEquals("robots[1] is about \"bob\", and one before is so already.", refusalWith("\"ann\"", "\"bob\""))
        assertEquals(
            "robots[0].firstProgram must be a whole number from 1 to 2.",
            refusalWith("\"firstProgram\": 2", "\"firstProgram\": 3"),
        )
        assertEquals(
            "robots[0].programs[1].language must be \"robolang\", \"java\", \"nqc\" or \"lasm\".",
            refusalWith("\"java\"", "\"basic\""),
        )
        assertEquals(
            "robots[0].programs[1].files[1] must not have \"size\".",
            refusalWith("\"name\": \"C.java\"", "\"size\": 5, \"name\": \"C.java\""),
        )
        assertEquals(
            "robots[0].programs[0].text[2] must be a text in quotes.",
            refusalWith("\\u0000\",\n            \"\"", "\\u0000\",\n            7"),
        )
        assertEquals("settings.realism must be from 0 to 1.", refusalWith("\"realism\": 0.25", "\"realism\": 2"))
        assertEquals("settings.java.mode must be \"brick\" or \"forgiving\".", refusalWith("\"forgiving\"", "\"kind\""))
        assertEquals("inputs[1].at must not be before the input above it.", refusalWith("\"at\": 0,", "\"at\": 11,"))
        assertEquals(
            "inputs[0].button must be \"on-off\", \"view\", \"prgm\", \"run\", \"enter\", \"left\", \"right\", " +
                "\"escape\", \"bluetooth\", \"up\" or \"down\".",
            refusalWith("\"on-off\"", "\"off\""),
        )
        assertEquals(
            "inputs[3].robot must be the name of a robot of the world.",
            refusalWith("\"placeRobot\", \"robot\": \"bob\"", "\"placeRobot\", \"robot\": 1"),
        )
        assertEquals("inputs[4].lamp must be a whole number from 1 to 2.", refusalWith("\"lamp\": 2", "\"lamp\": 3"))
        assertEquals("inputs[8].block must be a whole number from 1 to 2.", refusalWith("\"block\": 2", "\"block\": 0"))
        assertEquals("inputs[9].port must be a whole number from 1 to 3.", refusalWith("\"port\": 3", "\"port\": 4"))
        assertEquals("inputs[2] must not have \"x\".", refusalWith("\"stop\"", "\"stop\", \"x\": 1"))
        assertTrue(refusalWith("\"stop\"", "\"halt\"").startsWith("inputs[2].kind must be \"press\", \"release\""))
    }

    @Test
    fun `a project with any byte changed or cut off anywhere gives a result that holds`() {
        val random = Random(2005)
        val file = writeProject(FULL_PROJECT).encodeToByteArray()
        repeat(2000) {
            val changed = file.copyOf()
            repeat(random.nextInt(1, 4)) { changed[random.nextInt(changed.size)] = random.nextInt(256).toByte() }
            when (val result = readProject(changed, Language.ENGLISH)) {
                // Warnings are about the bytes as they were.
                is ProjectFileResult.Success -> assertEquals(
                    result.project,
                    assertIs<ProjectFileResult.Success>(
                        readProject(writeProject(result.project), Language.ENGLISH),
                    ).project,
                )

                is ProjectFileResult.Failure -> assertTrue(result.message.endsWith("."), result.message)
            }
        }
        for (length in 0..<file.indexOfLast {
            it == '}'.code.toByte()
        }) {
            assertIs<ProjectFileResult.Failure>(readProject(file.copyOf(length), Language.ENGLISH))
        }
    }

    private companion object {
        /** The command that stops all tasks. */
        const val STOP = 0x50
    }
}
