package robotran.blockediting

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.LineForm
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class BlocksOfTest {
    @Test
    fun `every program of the tree is its blocks byte for byte`() {
        assertTrue(allPrograms.size > 300, "${allPrograms.size} programs")
        for ((name, text) in allPrograms) {
            for (variant in listOf(
                text,
                text.replace("\n", "\r\n"),
                text.replace("  ", "\t"),
                text.trimEnd(),
                "\uFEFF$text",
            )) {
                checkPieces(variant, name)
            }
        }
    }

    @Test
    fun `the ports to choose from are those of the robot's brick`() {
        fun choices(text: String, brick: BrickKind): List<List<String>> {
            val program = blocksOf(text, RobolangMessages.of(Language.ENGLISH), brick = brick)
            assertNull(program.outline.lines.first().error)

            fun choicesIn(parts: List<PhrasePart>): List<List<String>> = parts.flatMap {
                when (it) {
                    is PhrasePart.Choice -> listOf(it.options)
                    is PhrasePart.Value -> choicesIn(it.value.parts)
                    else -> emptyList()
                }
            }
            return choicesIn(program.outline.lines.first().parts)
        }
        for (brick in BrickKind.entries) {
            val inputs = (1..brick.inputPorts).map { "$it" }
            assertEquals(listOf(inputs), choices("show sensor 2\n", brick), brick.label)
            val motors = brick.motorPorts.map { it.name }
            assertEquals(motors, choices("motor ${motors.last()} stop\n", brick).first(), brick.label)
        }
    }

    @Test
    fun `arbitrary and spoilt texts are their blocks byte for byte`() {
        val random = Random(SEED)
        repeat(TEXTS) {
            checkPieces(arbitraryText(random), "arbitrary $it")
            checkPieces(spoiltText(random), "spoilt $it")
        }
    }

    @Test
    fun `blocks nest as lines do, and comments and empty lines are blocks of their own`() {
        val text = """
            // a square
            repeat 4 times // sides
              forward 20

              if left bumper
                beep
              else if light < 40
                buzz
              else
                stop
              end
            end
        """.trimIndent()
        val shape = """
            // a square
            : repeat 4 times // sides
              forward 20
              blank
              : if left bumper
                beep
              : else if light < 40
                buzz
              : else
                stop
              : end
            : end
        """.trimIndent()
        assertEquals(shape, shapeOf(blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))))
    }

    @Test
    fun `a mistake in one line leaves the other lines as they are`() {
        val text = """
            repeat 4 tmes
              forwrd 20
              turn left 90
              if left bumpr
                beep
              edn
            end
            forward 20 30
            stop
        """.trimIndent()
        val shape = """
            loose: repeat 4 tmes
              loose forwrd 20
              turn left 90
              loose: if left bumpr
                beep
              loose: edn
            : end
            loose forward 20 30
            stop
        """.trimIndent()
        assertEquals(shape, shapeOf(blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))))
    }

    @Test
    fun `a misspelt first line opens a block if its end is exactly below`() {
        val shape = """
            : repeat 4 times
              loose: iff left bumper
                beep
              : end
              stop
            : end
        """.trimIndent()
        assertEquals(
            shape,
            shapeOf(
                blocksOf(
                    "repeat 4 times\n  iff left bumper\n    beep\n  end\n  stop\nend",
                    messages = RobolangMessages.of(Language.ENGLISH),
                ),
            ),
        )
        assertEquals(
            "loose hop 5\nbeep",
            shapeOf(blocksOf("hop 5\nbeep", messages = RobolangMessages.of(Language.ENGLISH))),
        )
    }

    @Test
    fun `a block without end stops where its message says, and its first line is no loose text`() {
        val program =
            blocksOf(
                "repeat 4 times\n  if left bumper\n    beep\n  forward 20\nend\nstop",
                messages = RobolangMessages.of(Language.ENGLISH),
            )
        assertEquals(": repeat 4 times\n  : if left bumper\n    beep\n    forward 20\n: end\nstop", shapeOf(program))
        val choice = assertIs<Block.Construct>(program.find("if"))
        assertNull(choice.foot)
        assertNotNull(choice.head.error?.fix)
    }

    @Test
    fun `an end and an else without a block are loose`() {
        assertEquals(
            "loose end\nbeep\nloose else\nstop",
            shapeOf(blocksOf("end\nbeep\nelse\nstop", messages = RobolangMessages.of(Language.ENGLISH))),
        )
    }

    @Test
    fun `blocks nested more deeply than allowed are loose and break nothing`() {
        val depth = 30_000
        val text = "repeat 2 times\n".repeat(depth) + "beep\n" + "end\n".repeat(depth)
        val program = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))
        assertEquals(text, textOf(program))
        assertEquals(99, program.find("beep").head.depth - 1)
    }

    @Test
    fun `a text that is too long is one loose block with the message`() {
        val program = blocksOf("beep\n".repeat(200_001), messages = RobolangMessages.of(Language.ENGLISH))
        assertNotNull(assertIs<Block.Loose>(program.blocks.single()).head.error)
        assertEquals(program.text, textOf(program))
    }

    @Test
    fun `a line is found by its number, a part by its place`() {
        val program =
            blocksOf(
                "repeat 4 times\n  forward 20 + x\n\n  beep\nend\nstop\n",
                messages = RobolangMessages.of(Language.ENGLISH),
            )
        val starts = listOf("repeat", "forward", "", "beep", "repeat", "stop")
        assertEquals(
            starts,
            (0..5).map {
                checkNotNull(program.blockOfLine(it)).head.span.textIn(program.text).trim().substringBefore(' ')
            },
        )
        assertNull(program.blockOfLine(6))
        for (part in piecesOf(program)) {
            val word = part.textIn(program.text)
            if (word.trim().isNotEmpty()) {
                assertEquals(part, program.partAt(part)?.span, word).takeIf {
                    word != "20 + x"
                }
            }
        }
        for (block in program.all) {
            val place = checkNotNull(program.placeOf(block.id))
            assertEquals(block.id, checkNotNull(program.blocksAt(place.parent, place.slot))[place.index].id)
            assertEquals(block.lines.first, program.lineIndexOf(place))
        }
    }

    @Test
    fun `blocks keep their ids when other lines change or they move`() {
        val before =
            blocksOf("forward 20\nbeep\nturn left 90\nstop\n", messages = RobolangMessages.of(Language.ENGLISH))
        val moved =
            blocksOf(
                "beep\nforward 20\nshow 5\nstop\n",
                previous = before,
                messages = RobolangMessages.of(Language.ENGLISH),
            )
        assertEquals(before.idOf("forward"), moved.idOf("forward"))
        assertEquals(before.idOf("beep"), moved.idOf("beep"))
        assertEquals(before.idOf("stop"), moved.idOf("stop"))
        assertEquals(before.idOf("turn"), moved.idOf("show"), "changed in place")
        assertEquals(4, moved.all.map { it.id }.toSet().size)
    }

    @Test
    fun `the form and the exact places of the parts are known`() {
        val program = blocksOf("  FORWARD   - 20  cm // far\n", messages = RobolangMessages.of(Language.ENGLISH))
        val line = program.blocks.single().head
        assertEquals(LineForm.MOVE, line.form)
        assertEquals(listOf("FORWARD", "- 20", "cm"), line.parts.map { it.span.textIn(program.text) })
        assertEquals("// far", line.comment?.textIn(program.text))
    }
}

/** Checks that the pieces of [text] cover it without gaps, and that each line belongs to one block. */
internal fun checkPieces(text: String, name: String) {
    val program = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))
    assertEquals(text, textOf(program), name)
    val lines = mutableListOf<Int>()

    fun add(blocks: List<Block>) {
        for (block in blocks) {
            if (block !is Block.Construct) lines += block.head.index
            (block as? Block.Construct)?.slots?.forEach {
                lines += it.head.index
                add(it.blocks)
            }
            (block as? Block.Construct)?.foot?.let { lines += it.index }
        }
    }
    add(program.blocks)
    assertEquals((0..<program.lineCount).toList(), lines, name)
    assertTrue(program.lineCount >= program.outline.lines.size - 1, name)
    for (block in program.all) {
        val isRead =
            block is Block.Command || block is Block.Comment || block is Block.Blank || block is Block.Construct
        assertTrue(isRead || block.head.form == null, name)
    }
}

private const val SEED = 23
private const val TEXTS = 5_000
