package robotran.legofirmware.listing

import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.SymbolKind
import robotran.legofirmware.image.hexByte

/**
 * The program as a listing for people: addresses, commands, bytes. It is the one that NQC's own compiler prints, except
 * that it shows the true target of every branch: the original shows far branches 256 too small.
 */
fun RcxImage.plainListing(): String = buildString {
    for (symbol in symbols.filter { it.kind == SymbolKind.VARIABLE }) {
        append("*** Var ${symbol.number} = ${printable(symbol.name)}\n")
    }
    for (chunk in chunks.sortedBy { it.id }) {
        append("\n*** ${headerOf(chunk)}\n")
        for (part in chunk.code.parts()) append(codeLine(chunk, part)).append('\n')
    }
    append("\nTotal size: $codeSize bytes\n")
}

/** Kind, number, name and size, as in both forms of a listing. */
internal fun RcxImage.headerOf(chunk: Chunk): String =
    "${chunk.id.title} = ${printable(nameOf(chunk.id).orEmpty())}, size: ${chunk.code.size} bytes"

/** A name from a file, on one line. */
internal fun printable(name: String): String = name.map { if (it.isISOControl()) '?' else it }.joinToString("")

internal val ChunkId.title: String get() = (if (kind == ChunkKind.TASK) "Task " else "Sub ") + number

private const val ADDRESS_DIGITS = 3
private const val TEXT_COLUMNS = 42
private const val MNEMONIC_COLUMNS = 8

private fun codeLine(chunk: Chunk, part: CodePart): String {
    val address = part.address.toString().padStart(ADDRESS_DIGITS, '0')
    val bytes = (part.address until part.address + part.size).joinToString("") { hexByte(chunk.code[it]) + " " }
    return "$address ${part.text().padEnd(TEXT_COLUMNS)} $bytes"
}

private fun CodePart.text(): String = when (this) {
    is CodePart.Unknown -> "?"

    is CodePart.Command -> {
        placed.instruction.opcode.mnemonic.padEnd(MNEMONIC_COLUMNS) + " " + placed.instruction.plainOperands()
    }
}
