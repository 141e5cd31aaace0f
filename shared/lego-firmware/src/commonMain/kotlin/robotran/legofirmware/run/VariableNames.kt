package robotran.legofirmware.run

import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.image.SymbolKind

/** Which variables of [program] to show, and how they are called. */
internal class VariableNames(private val program: ProgramCode) {
    private val symbols: Map<Int, List<String>> =
        program.image.symbols.filter { it.kind == SymbolKind.VARIABLE }.groupBy({ it.number }, { it.name })

    /** Those that the image names; in one without any names, those that it uses. */
    private val ofImage: Map<Int, List<String>> =
        symbols.ifEmpty { VariablesUsed.of(program.image).associateWith { listOf("var[$it]") } }

    /** Those of all tasks by number, in the order of these. */
    val shared: Map<Int, String> =
        named(program.variables?.shared ?: ofImage.filterKeys { it < FirmwareLimits.GLOBAL_VARIABLES })

    /** Those with a name that are in the brick only once, by number, whoever knows them. */
    val single: Map<Int, String> get() = named(symbols.filterKeys { it < FirmwareLimits.GLOBAL_VARIABLES })

    /** Those that only the tasks and subroutines [chunks] know, likewise. */
    fun own(chunks: Set<ChunkId>): Map<Int, String> {
        val table = program.variables ?: return named(ofImage.filterKeys { it >= FirmwareLimits.GLOBAL_VARIABLES })
        val all = chunks.flatMap { table.own[it].orEmpty().entries }
        return named(all.groupBy({ it.key }, { it.value }).mapValues { it.value.flatten() })
    }

    private fun named(variables: Map<Int, List<String>>): Map<Int, String> = variables.keys.sorted()
        .associateWith { variables.getValue(it).distinct().joinToString(" / ") }
}
