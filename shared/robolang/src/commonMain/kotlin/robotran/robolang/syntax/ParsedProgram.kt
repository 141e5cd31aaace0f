package robotran.robolang.syntax

/**
 * What the parser makes of a source.
 *
 * @property names every place where a name stands, in the order of the source.
 * @property isDoubtful whether blocks may begin or end elsewhere than it seems, so that nothing that depends on it
 * should be blamed.
 */
internal class ParsedProgram(
    val tree: SyntaxTree,
    val lines: List<ScannedLine>,
    val names: List<Name>,
    val isDoubtful: Boolean,
)
