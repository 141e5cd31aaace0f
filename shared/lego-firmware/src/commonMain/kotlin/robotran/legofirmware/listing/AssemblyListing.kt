package robotran.legofirmware.listing

import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.CodeLine
import robotran.legofirmware.image.LineTable
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.SymbolKind
import robotran.legofirmware.instructions.encode

/**
 * A program as assembly text.
 *
 * @property text as NQC's own compiler prints it. What its text cannot say is a line `byte`, so that assembling the text
 * gives the image again, whatever its code is.
 * @property lines the line of each command in [text].
 */
class AssemblyListing(val text: String, val lines: LineTable)

/** The program as assembly text. */
fun RcxImage.assemblyListing(): AssemblyListing = AssemblyWriter(this).write()

/** A line of assembly text with bytes, for code that is no command. */
internal const val BYTES_MNEMONIC = "byte"

private class AssemblyWriter(private val image: RcxImage) {
    private val text = StringBuilder()
    private var line = 1
    private val lines = mutableMapOf<ChunkId, List<CodeLine>>()

    fun write(): AssemblyListing {
        for (symbol in image.symbols.filter { it.kind == SymbolKind.VARIABLE }) {
            add("; Var ${symbol.number} = ${printable(symbol.name)}")
        }
        image.chunks.sortedBy { it.id }.forEach { write(it) }
        add("")
        add(";Total size: ${image.codeSize} bytes")
        return AssemblyListing(text.toString(), LineTable(lines))
    }

    private fun write(chunk: Chunk) {
        val isTask = chunk.id.kind == ChunkKind.TASK
        add("")
        add("; ${image.headerOf(chunk)}")
        add(";${printable(image.nameOf(chunk.id).orEmpty())}")
        add("\t${if (isTask) "task" else "sub"}\t${chunk.id.number}")
        val parts = chunk.code.parts()
        val ends = parts.mapTo(mutableSetOf(chunk.code.size)) { it.address }
        val commands = parts.filterIsInstance<CodePart.Command>().filter { isSayable(chunk, it, ends) }.toSet()
        val targets = commands.mapNotNullTo(mutableSetOf()) { it.placed.instruction.target }
        lines[chunk.id] = parts.map { part ->
            if (part.address in targets) add(labelOf(chunk.id, part.address) + ":")
            val codeLine = CodeLine(part.address, line)
            add(if (part in commands) commandLine(chunk.id, part as CodePart.Command) else bytesLine(chunk, part))
            codeLine
        }
        if (chunk.code.size in targets) add(labelOf(chunk.id, chunk.code.size) + ":")
        add(if (isTask) "\tendt" else "\tends")
    }

    /** Whether assembling the command gives its bytes again. */
    private fun isSayable(chunk: Chunk, command: CodePart.Command, ends: Set<Int>): Boolean {
        val instruction = command.placed.instruction
        val target = instruction.target
        if (target != null && target !in ends) return false
        val bytes = instruction.canonical().encode(command.address)
        return (0 until bytes.size).all { bytes[it] == chunk.code[command.address + it] }
    }

    private fun commandLine(chunk: ChunkId, command: CodePart.Command): String {
        val instruction = command.placed.instruction
        return "\t${instruction.opcode.mnemonic}\t${instruction.assemblyOperands { labelOf(chunk, it) }} "
    }

    private fun bytesLine(chunk: Chunk, part: CodePart): String {
        val bytes = (part.address until part.address + part.size).joinToString { "${chunk.code[it]}" }
        return "\t$BYTES_MNEMONIC\t$bytes "
    }

    private fun add(content: String) {
        text.append(content).append('\n')
        line++
    }
}

private const val CHUNK_DIGITS = 3
private const val ADDRESS_DIGITS = 4

/** The name of a jump's target, such as `t0000060` in task 0. */
private fun labelOf(chunk: ChunkId, address: Int): String {
    val letter = if (chunk.kind == ChunkKind.TASK) "t" else "s"
    return letter + chunk.number.toString().padStart(CHUNK_DIGITS, '0') +
        address.toString().padStart(ADDRESS_DIGITS, '0')
}
