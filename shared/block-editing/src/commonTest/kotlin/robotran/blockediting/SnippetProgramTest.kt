package robotran.blockediting

import robotran.blockediting.palette.Palette
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.words.BlockGroup
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class SnippetProgramTest {
    private val program = blocksOf(
        """
        robot
          light sensor on 2 facing down
        end
        const corner = 90 // degrees
        var side = corner / 9
        pen down
        repeat 4 times
          forward side
          turn left corner
        end
        procedure square(length)
          forward length
        end
        procedure two()
          square(5)
          square(double(side))
        end
        function double(x)
          return x * 2
        end
        for i from 1 to 3
          forward i
        end
        two()
        """.trimIndent(),
        messages = RobolangMessages.of(Language.ENGLISH),
    )

    private fun trial(words: String, count: Int = 1): SnippetProgram {
        val block = program.all.first { it.head.span.textIn(program.text).trim() == words }
        return snippetOf(program, BlockRun(block.id, count))
    }

    /** The lines that are left, with their numbers. */
    private fun SnippetProgram.lines(): List<String> = (this as SnippetProgram.Success).text.lines()
        .mapIndexedNotNull { index, line -> line.trim().takeIf { it.isNotEmpty() }?.let { "${index + 1} $it" } }

    private val robot = listOf("1 robot", "2 light sensor on 2 facing down", "3 end")

    @Test
    fun `a trial has only the blocks that were asked for, at their lines`() {
        assertEquals(robot + "6 pen down", trial("pen down").lines())
    }

    @Test
    fun `a construct comes with what is inside and the names that it uses`() {
        val declared = listOf("4 const corner = 90 // degrees", "5 var side = corner / 9")
        val loop = listOf("7 repeat 4 times", "8 forward side", "9 turn left corner", "10 end")
        assertEquals(robot + declared + loop, trial("repeat 4 times").lines())
        assertEquals(robot + declared + "6 pen down" + loop, trial("pen down", 2).lines())
    }

    @Test
    fun `a call comes with all own commands that it leads to`() {
        val numbers = trial("two()").lines().map { it.substringBefore(' ').toInt() }
        assertEquals((1..5) + (11..20) + 24, numbers)
    }

    @Test
    fun `a procedure without parameters is called`() {
        val lines = trial("procedure two()").lines()
        assertTrue("14 procedure two()" in lines)
        assertEquals("25 two()", lines.last())
    }

    @Test
    fun `a value of a loop or a parameter is refused by its name`() {
        assertEquals(SnippetProgram.Failure(BlockEditError.ValueUnknown("i")), trial("forward i"))
        assertEquals(SnippetProgram.Failure(BlockEditError.ValueUnknown("length")), trial("forward length"))
    }

    @Test
    fun `a loop whose value is used inside of it can be tried`() {
        assertEquals(
            robot + listOf("21 for i from 1 to 3", "22 forward i", "23 end"),
            trial("for i from 1 to 3").lines(),
        )
    }

    @Test
    fun `what only defines something does nothing alone`() {
        for (words in listOf("procedure square(length)", "function double(x)", "robot")) {
            assertEquals(SnippetProgram.Failure(BlockEditError.NothingToTry), trial(words), words)
        }
        val comment = blocksOf("// a note\n\nbeep\n", messages = RobolangMessages.of(Language.ENGLISH))
        val first = comment.blocks.first().id
        assertEquals(SnippetProgram.Failure(BlockEditError.NothingToTry), snippetOf(comment, BlockRun(first, 2)))
    }

    @Test
    fun `a block of the palette comes behind the program`() {
        assertEquals(robot + "25 forward 20", snippetOf(program, "forward 20\n").lines())
        assertEquals("25 square(5)", snippetOf(program, "square(5)").lines().last())
        assertEquals(
            listOf("4 beep"),
            snippetOf(
                blocksOf("pen up\r\npen down\r\n", messages = RobolangMessages.of(Language.ENGLISH)),
                "beep",
            ).lines(),
        )
        assertEquals(
            listOf("2 beep"),
            snippetOf(blocksOf("", messages = RobolangMessages.of(Language.ENGLISH)), "beep").lines(),
        )
    }

    @Test
    fun `the palette lets try what moves, draws, shows or sounds`() {
        val tried = Palette.blocks.filter { it.canBeTried }
        assertEquals(
            setOf(BlockGroup.DRIVE, BlockGroup.PEN, BlockGroup.SHOW_AND_SOUND),
            tried.map { it.group }.toSet(),
        )
        assertEquals(
            Palette.blocksOf(BlockGroup.SHOW_AND_SOUND, brick = BrickKind.RCX),
            tried.filter { it.group == BlockGroup.SHOW_AND_SOUND },
        )
        for (block in tried) {
            assertTrue(
                block.template in
                    (
                        snippetOf(
                            blocksOf("", messages = RobolangMessages.of(Language.ENGLISH)),
                            block.template,
                        ) as SnippetProgram.Success
                    ).text,
            )
        }
    }
}
