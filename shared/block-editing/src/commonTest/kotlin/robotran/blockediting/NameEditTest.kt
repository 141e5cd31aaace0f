package robotran.blockediting

import robotran.language.Language
import robotran.language.source.SourceSpan
import robotran.robolang.messages.RobolangMessages
import kotlin.test.Test
import kotlin.test.assertEquals

class NameEditTest {
    @Test
    fun `a name is renamed wherever it is used, and nowhere else`() {
        val text = "var side = 5 // side\nprocedure p(side)\n  forward side\nend\nforward SIDE\nforwrd side\np(side)\n"
        val program = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))
        val expected = "var length2 = 5 // side\nprocedure p(side)\n  forward side\nend\n" +
            "forward length2\nforwrd length2\np(length2)\n"
        val declared = program.span("side")
        assertEquals(expected, program.done(BlockEdit.Rename(declared, "length2")).program.text)
        assertEquals(BlockEditError.NoName("2x"), program.editError(BlockEdit.Rename(declared, "2x")))
        assertEquals(BlockEditError.NameTaken("max"), program.editError(BlockEdit.Rename(declared, "max")))
        assertEquals(
            BlockEditError.NameTaken("max"),
            program.editError(
                BlockEdit.Rename(
                    program.span("p(").let {
                        it.copy(
                            end =
                                it.start + 1,
                        )
                    },
                    "max",
                ),
            ),
        )
    }

    @Test
    fun `a new name is declared where it is used first`() {
        assertEquals(
            "// go\nvar side = 20\nforward side\n",
            after("// go\nforward 20\n") { BlockEdit.UseNewName(span("20"), "side") },
        )
        assertEquals(
            "const k = 1\nvar b = left bumper\nrepeat 2 times\n  wait until b\nend\nshow k\n",
            after("const k = 1\nrepeat 2 times\n  wait until timer > 5\nend\nshow k\n") {
                BlockEdit.UseNewName(span("timer > 5"), "b")
            },
        )
        assertEquals(
            "var y = 5\nvar x = y\n",
            after("var x = 1\n") { BlockEdit.UseNewName(span("1"), "y") },
        )
        assertEquals(
            "dance()\n\nprocedure dance()\nend",
            after("jump()") { BlockEdit.UseNewName(span("jump"), "dance") },
        )
        assertEquals(
            BlockEditError.NameTaken("x"),
            editError("var x = 1\nshow 2\n") { BlockEdit.UseNewName(span("2"), "x") },
        )
        assertEquals(BlockEditError.NoName("end"), editError("show 2\n") { BlockEdit.UseNewName(span("2"), "end") })
    }

    @Test
    fun `own commands get and lose parameters, and so do their calls`() {
        val text = "go()\nshow f(f(1, 2), 3)\nprocedure go()\nend\nfunction f(a, b)\n  return a\nend\n"
        val go = SourceSpan(text.indexOf("go()\nend"), text.indexOf("go()\nend") + 2)
        val f = SourceSpan(text.indexOf("f(a"), text.indexOf("f(a") + 1)
        assertEquals(
            text.replace("go()\nshow", "go(5)\nshow").replace("go()\nend", "go(far)\nend"),
            blocksOf(
                text,
                messages = RobolangMessages.of(Language.ENGLISH),
            ).done(BlockEdit.AddParameter(go, "far")).program.text,
        )
        assertEquals(
            text.replace("f(f(1, 2), 3)", "f(f(1, 2, 5), 3, 5)").replace("a, b", "a, b, c"),
            blocksOf(
                text,
                messages = RobolangMessages.of(Language.ENGLISH),
            ).done(BlockEdit.AddParameter(f, "c")).program.text,
        )
        assertEquals(
            text.replace("f(f(1, 2), 3)", "f(f(1), 3)").replace("f(f(1), 3)", "f(f(1))").replace("a, b", "a"),
            blocksOf(
                text,
                messages = RobolangMessages.of(Language.ENGLISH),
            ).done(BlockEdit.RemoveParameter(f, 1)).program.text,
        )
        assertEquals(
            text.replace("f(f(1, 2), 3)", "f(3)").replace("a, b", "b"),
            blocksOf(
                text,
                messages = RobolangMessages.of(Language.ENGLISH),
            ).done(BlockEdit.RemoveParameter(f, 0)).program.text,
        )
        assertEquals(
            BlockEditError.NameTaken("a"),
            blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH)).editError(BlockEdit.AddParameter(f, "a")),
        )
    }
}
