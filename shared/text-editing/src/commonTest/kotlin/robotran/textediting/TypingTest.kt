package robotran.textediting

import robotran.language.ProgramLanguage
import robotran.programs.support
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import kotlin.test.Test
import kotlin.test.assertEquals

class TypingTest {
    /** A draft with the caret at `|`, or the selection between two of them. */
    private fun at(marked: String): TextDocument {
        val first = marked.indexOf('|')
        val last = marked.lastIndexOf('|')
        val text = marked.replace("|", "")
        return TextDocument(text, TextSelection(first, if (last > first) last - 1 else first))
    }

    private fun TextDocument.marked() = text.replaceRange(selection.caret, selection.caret, "|")

    private fun typed(before: String, typed: String, language: ProgramLanguage = ProgramLanguage.ROBOLANG): String =
        typed.fold(at(before)) { draft, character -> draft.typed(character.toString(), language.support.code) }.marked()

    @Test
    fun `a new line stands as far right as the one above`() = assertEquals("  beep\n  |", typed("  beep|", "\n"))

    @Test
    fun `a new line inside a block stands further right`() =
        assertEquals("repeat forever\n  |", typed("repeat forever|", "\n"))

    @Test
    fun `the end of a block goes back to where the block began`() =
        assertEquals("if light < 40\n  beep\nelse\n  buzz\nend|", typed("if light < 40|", "\nbeep\nelse\nbuzz\nend"))

    @Test
    fun `the end of an inner block finds its own beginning`() = assertEquals(
        "repeat forever\n  if left bumper\n    beep\n  end\nend|",
        typed("repeat forever|", "\nif left bumper\nbeep\nend\nend"),
    )

    @Test
    fun `a curly bracket opens and closes a block of Java`() =
        assertEquals("while (true) {\n    go();\n}|", typed("while (true) {|", "\ngo();\n}", ProgramLanguage.JAVA))

    @Test
    fun `a curly bracket opens and closes a block of NQC`() = assertEquals(
        "task main()\n{\n    go();\n}|",
        typed("task main()|", "\n{\ngo();\n}", ProgramLanguage.NQC),
    )

    @Test
    fun `a line of assembly text stands below the one above`() =
        assertEquals("\twait 2, 1\n\t|", typed("\twait 2, 1|", "\n", ProgramLanguage.LASM))

    @Test
    fun `a new line between two curly brackets makes room between them`() =
        assertEquals("    void go() {\n        |\n    }", typed("    void go() {|}", "\n", ProgramLanguage.JAVA))

    @Test
    fun `a curly bracket in a text opens nothing`() =
        assertEquals("say(\"{\");\n|", typed("say(\"{\");|", "\n", ProgramLanguage.JAVA))

    @Test
    fun `what is selected goes when something is typed`() = assertEquals("for|ward", typed("|back|ward", "for"))

    @Test
    fun `what comes from the clipboard gets our line ends and no tabs`() =
        assertEquals("a\n  b\nc|", at("|").typed("a\r\n\tb\rc", ProgramLanguage.ROBOLANG.support.code).marked())

    @Test
    fun `erasing goes a step to the left before a line and a character otherwise`() {
        assertEquals("  |beep", at("    |beep").erasedBackwards(ProgramLanguage.ROBOLANG.support.code).marked())
        assertEquals("    be|p", at("    bee|p").erasedBackwards(ProgramLanguage.ROBOLANG.support.code).marked())
        assertEquals("|beep", at("\uD83D\uDE00|beep").erasedBackwards(ProgramLanguage.ROBOLANG.support.code).marked())
    }

    @Test
    fun `words can be erased to both sides`() {
        assertEquals("turn |90", at("turn left |90").wordErasedBackwards().marked())
        assertEquals("turn| 90", at("turn| left 90").wordErasedForwards().marked())
    }

    @Test
    fun `lines go further right and left together`() {
        val draft = at("a\n|b\n\nc|\nd")
        assertEquals("a\n  b\n\n  c\nd", draft.indented(ProgramLanguage.ROBOLANG.support.code).text)
        assertEquals(
            draft.text,
            draft.indented(
                ProgramLanguage.ROBOLANG.support.code,
            ).unindented(ProgramLanguage.ROBOLANG.support.code).text,
        )
    }

    @Test
    fun `lines become comments and code again`() {
        val draft = at("repeat forever\n|  beep\n\n    buzz|\nend")
        val commented = draft.withCommentToggled(ProgramLanguage.ROBOLANG.support.code)
        assertEquals("repeat forever\n  // beep\n\n  //   buzz\nend", commented.text)
        assertEquals(draft.text, commented.withCommentToggled(ProgramLanguage.ROBOLANG.support.code).text)
        val assembly = at("\tplays\t|3\n")
        assertEquals("\t; plays\t3\n", assembly.withCommentToggled(ProgramLanguage.LASM.support.code).text)
        assertEquals(
            assembly.text,
            assembly.withCommentToggled(
                ProgramLanguage.LASM.support.code,
            ).withCommentToggled(ProgramLanguage.LASM.support.code).text,
        )
    }

    @Test
    fun `lines change places with their neighbours`() {
        assertEquals("b\n|a\nc", at("|a\nb\nc").withLinesMovedDown().marked())
        assertEquals("a\n|c\nb", at("a\nb\n|c").withLinesMovedUp().marked())
        assertEquals("|a", at("|a").withLinesMovedUp().withLinesMovedDown().marked())
    }

    @Test
    fun `lines can be doubled and taken out`() {
        assertEquals("ab\na|b\nc", at("a|b\nc").withLinesDuplicated().marked())
        assertEquals("c|", at("c\na|b").withoutLines().marked())
        assertEquals("|", at("a|b").withoutLines().marked())
        assertEquals("a\nc|", at("a\nb|\nc").withoutLines().marked())
    }
}
