package robotran.robolang.format

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.syntax.Parser
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.brickIn
import robotran.robolang.syntax.scan
import kotlin.test.assertEquals

/** Checks that formatting [source] keeps its meaning and is idempotent. Ignores a source with syntax errors. */
internal fun checkFormatting(source: String) {
    val formatted =
        (formatRobolang(source, messages = RobolangMessages.of(Language.ENGLISH)) as? FormatResult.Success)?.text
            ?: return
    assertEquals(
        FormatResult.Success(formatted),
        formatRobolang(formatted, messages = RobolangMessages.of(Language.ENGLISH)),
    )
    assertEquals(withoutPlaces(treeOf(source)), withoutPlaces(treeOf(formatted)))
}

internal fun treeOf(source: String): SyntaxTree {
    val diagnostics = DiagnosticSink(RobolangMessages.of(Language.ENGLISH))
    val lines = scan(source, diagnostics)
    diagnostics.brick = brickIn(lines) ?: BrickKind.RCX
    return Parser(lines, diagnostics).program().tree
}

/** The tree as text, without source ranges and with names in lower case. */
private fun withoutPlaces(tree: SyntaxTree): String =
    tree.toString().replace(PLACE, "").replace(TEXT_OF_NAME) { it.value.lowercase() }

private val PLACE = Regex("""SourceRange\([^)]*\)""")
private val TEXT_OF_NAME = Regex("""Name\([^)]*\)""")
