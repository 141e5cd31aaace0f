package robotran.blockediting

import robotran.blockediting.palette.Palette
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.PhrasePart
import robotran.robolang.wording.ChangedWords
import robotran.robolang.wording.changeWords
import robotran.robolang.words.Vocabulary
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** An edit of a program in other words does the same as on the program in English. */
class OtherWordsTest {
    private val english = """
        // A program.
        robot
          light sensor on 2 facing down
        end

        var side = 20
        repeat 4 times
          forward side
          turn left 90
          wait 1 second
        end
        if left bumper and not right bumper
          show light
        else
          play 440 for 2 seconds
        end
        for i from 1 to 10
          motor A forward
        end
        show "stop end"
    """.trimIndent() + "\n"
    private val languages = Language.entries - Language.ENGLISH

    @Test
    fun `blocks of the palette come in the words of the program`() {
        for (block in Palette.blocks.filterNot { it.isValue }) {
            assertSame(BlockEdit.Insert(block.template, BlockPlace(null, 0, 3)))
            assertSame(BlockEdit.Insert(block.template, BlockPlace(null, 0, 0)))
        }
    }

    @Test
    fun `constructs, branches, forms and copies are written in the words of the program`() {
        val program = read(english)
        for (block in program.all) {
            assertSame(BlockEdit.Duplicate(BlockRun(block.id)))
            assertSame(BlockEdit.Wrap(BlockRun(block.id), "repeat 2 times\nend"))
            assertSame(BlockEdit.Wrap(BlockRun(block.id), "if light < 40\nend"))
            assertSame(BlockEdit.AddElse(block.id, "right bumper"))
            assertSame(BlockEdit.Unwrap(block.id))
            for (form in block.head.form?.let(::formsFor).orEmpty()) {
                assertSame(BlockEdit.ChangeForm(block.head.index, form))
            }
        }
    }

    @Test
    fun `values and choices are written in the words of the program`() {
        val program = read(english)
        for (line in program.outline.lines) {
            line.parts.forEachIndexed { index, part ->
                val texts = when (part) {
                    is PhrasePart.Choice -> part.options
                    is PhrasePart.Value -> listOf("1", "timer", "light < 40", "button run", "random(1, 6)")
                    else -> emptyList()
                }
                for (text in texts) {
                    assertSame({ BlockEdit.Replace(it.outline.lines[line.index].parts[index].span, text) })
                }
            }
        }
    }

    private fun assertSame(edit: BlockEdit) = assertSame { edit }

    private fun assertSame(edit: (BlockProgram) -> BlockEdit) {
        val program = read(english)
        val expected = apply(program, edit(program))
        for (language in languages) {
            val other = read(inWords(english, language))
            val result = apply(other, edit(other))
            if (expected !is BlockEditResult.Success) {
                assertTrue(result is BlockEditResult.Failure, "${edit(program)}")
                continue
            }
            val text = assertIs<BlockEditResult.Success>(result, "${edit(program)} in $language").program.text
            assertEquals(inWords(expected.program.text, language), text, "${edit(program)}")
        }
    }

    private fun read(text: String) = blocksOf(text, RobolangMessages.of(Language.ENGLISH))

    private fun inWords(text: String, language: Language): String =
        assertIs<ChangedWords.Success>(changeWords(text, Vocabulary.of(language))).text
}
