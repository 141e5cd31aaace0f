package robotran.robolang.syntax

/**
 * The result of parsing a source.
 *
 * @property names all occurrences of names, in source order.
 * @property isUncertain whether the block structure is uncertain, so that errors that depend on it must not be reported.
 * @property edges the lines that open, branch or close a block, by their number.
 * @property lackingEnds the blocks without an `end`.
 */
internal class ParsedProgram(
    val tree: SyntaxTree,
    val lines: List<ScannedLine>,
    val names: List<Name>,
    val isUncertain: Boolean,
    val edges: Map<Int, BlockEdge>,
    val lackingEnds: List<MissingEnd>,
)
