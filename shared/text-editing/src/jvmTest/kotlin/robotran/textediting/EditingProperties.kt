package robotran.textediting

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.languagesupport.CompletionHelp
import robotran.programs.support
import robotran.textediting.complete.completed
import robotran.textediting.complete.completionsAt
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import robotran.textediting.text.withWordSelected

class EditingProperties :
    FunSpec({
        test("a change makes the one text of the other, and taken back the other of the one") {
            checkAll(texts, texts) { before, after ->
                val edit = editBetween(before, after)
                (edit?.applyTo(before) ?: before) shouldBe after
                (edit?.inverse?.applyTo(after) ?: after) shouldBe before
            }
        }

        test("undoing everything gives the first text back, and doing it again the last") {
            checkAll(drafts, Arb.list(actions, 0..30)) { first, done ->
                var history = EditHistory()
                val last = done.fold(first) { draft, action ->
                    val after = action.change(draft)
                    history = history.recorded(draft, after, action.kind)
                    after
                }
                var draft = last
                while (true) {
                    val (before, rest) = history.undone(draft) ?: break
                    draft = before
                    history = rest
                }
                draft.text shouldBe first.text
                while (true) {
                    val (after, rest) = history.redone(draft) ?: break
                    draft = after
                    history = rest
                }
                draft.text shouldBe last.text
            }
        }

        test("whatever is done, the caret is in the text") {
            checkAll(drafts, Arb.list(actions, 0..20)) { first, done ->
                done.fold(first) { draft, action ->
                    action.change(draft).also {
                        it.selection.start shouldBeInRange 0..it.text.length
                        it.selection.end shouldBeInRange 0..it.text.length
                    }
                }
            }
        }

        test("a window always maps back onto the text") {
            checkAll(drafts, texts, Arb.int(0..200)) { short, typed, repeats ->
                val text = short.text + "forward 20\n".repeat(repeats * 2)
                val draft =
                    TextDocument(
                        text,
                        TextSelection(
                            short.selection.anchor,
                            short.selection.caret * (repeats + 1),
                        ).within(text.length),
                    )
                val window = InputWindow.of(draft)
                val held = window.textOf(draft)
                val selected = window.selectionOf(draft)
                window.applied(draft, held, selected) shouldBe draft
                val changed = held.replaceRange(selected.start, selected.end, typed)
                val after = window.applied(draft, changed, TextSelection(selected.start + typed.length))
                if (window.containsSelection || typed != held) after shouldBe draft.replaced(typed)
            }
        }

        test("marks stay on lines that are there") {
            checkAll(drafts, Arb.list(actions, 1..10), Arb.list(Arb.int(1..6), 0..4)) { first, done, marked ->
                var marks = marked.filterTo(mutableSetOf()) { it <= first.lines.count }.toSet()
                done.fold(first) { draft, action ->
                    val after = action.change(draft)
                    editBetween(draft.text, after.text)?.let { marks = marks.movedWith(it, draft.lines) }
                    marks.forEach { it shouldBeInRange 1..after.lines.count }
                    after
                }
            }
        }

        test("the pieces of a line come in order and inside it, whatever it holds") {
            checkAll(texts, Arb.enum<ProgramLanguage>()) { text, language ->
                for (line in text.split('\n')) {
                    language.support.code.tokens(line, startsInComment = false, brick = BrickKind.RCX).tokens.fold(0) {
                        done,
                        token,
                        ->
                        token.start shouldBeInRange done..line.length
                        token.end shouldBeInRange token.start..line.length
                        token.end
                    }
                }
            }
        }

        test("Java that is laid out stays as it is and keeps all that is not blank") {
            checkAll(texts) { text ->
                val java = ProgramLanguage.JAVA.support.code
                val once = java.format(text).orEmpty()
                java.format(once) shouldBe once
                once.filterNot { it.isWhitespace() } shouldBe text.filterNot { it.isWhitespace() }
            }
        }

        test("completing never fails and leaves what stands before it") {
            checkAll(drafts, Arb.enum<ProgramLanguage>()) { draft, language ->
                val list =
                    completionsAt(
                        draft,
                        language.support.code,
                        CompletionHelp {
                            null
                        },
                        isExplicit = true,
                        brick = BrickKind.RCX,
                    )
                for (item in list?.items.orEmpty()) {
                    draft.completed(list!!, item).text.take(list.start) shouldBe
                        draft.text.take(list.start)
                }
            }
        }
    })

private class Action(val kind: EditKind, val change: (TextDocument) -> TextDocument)

private val texts: Arb<String> = Arb.list(
    Arb.element(
        "repeat 4 times",
        "end",
        "else",
        "if",
        " ",
        "  ",
        "\n",
        "\n",
        "{",
        "}",
        "(",
        ")",
        "\"",
        "'",
        "/*",
        "*/",
        "//",
        "x",
        "Motor.A.",
        "for",
        ";",
        ",",
        "\t",
        "\uD83D\uDE00",
        "ß",
        "0",
        "[",
        "]",
        "* ",
        "else {",
    ),
    0..14,
).map { it.joinToString("") }

private val drafts: Arb<TextDocument> = arbitrary { random ->
    val text = texts.sample(random).value
    val place = Arb.int(0..text.length)
    TextDocument(text, TextSelection(place.sample(random).value, place.sample(random).value))
}

private val actions: Arb<Action> = Arb.element(
    listOf("a", " ", "\n", "end", "}", "{", "x y", "\uD83D\uDE00")
        .map { typed -> Action(EditKind.TYPING) { it.typed(typed, ProgramLanguage.ROBOLANG.support.code) } } +
        CaretMove.entries.map { move -> Action(EditKind.OTHER) { it.moved(move, selecting = move.ordinal % 2 == 0) } } +
        listOf(
            Action(EditKind.ERASING) { it.erasedBackwards(ProgramLanguage.JAVA.support.code) },
            Action(EditKind.ERASING) { it.erasedForwards() },
            Action(EditKind.ERASING) { it.wordErasedBackwards() },
            Action(EditKind.ERASING) { it.wordErasedForwards() },
            Action(EditKind.OTHER) { it.indented(ProgramLanguage.JAVA.support.code) },
            Action(EditKind.OTHER) { it.unindented(ProgramLanguage.JAVA.support.code) },
            Action(EditKind.OTHER) { it.withCommentToggled(ProgramLanguage.JAVA.support.code) },
            Action(EditKind.OTHER) { it.withLinesMovedUp() },
            Action(EditKind.OTHER) { it.withLinesMovedDown() },
            Action(EditKind.OTHER) { it.withLinesDuplicated() },
            Action(EditKind.OTHER) { it.withoutLines() },
            Action(EditKind.OTHER) { it.withWordSelected(it.selection.caret) },
            Action(EditKind.OTHER) { it.typed("}", ProgramLanguage.JAVA.support.code) },
        ),
)
