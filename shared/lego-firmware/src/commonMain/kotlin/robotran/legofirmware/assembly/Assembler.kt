package robotran.legofirmware.assembly

import robotran.language.Language
import robotran.language.source.Severity
import robotran.legofirmware.image.Chunk
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.image.CodeLine
import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.LineTable
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.messages.AssemblyMessages
import robotran.legofirmware.messages.ImageMessages

/** Gives each command its address, then encodes all. */
internal class Assembler(language: Language, private val target: FirmwareTarget) {
    private val messages = AssemblyMessages.of(language)
    private val imageMessages = ImageMessages.of(language)
    private val sink = AssemblySink()
    private val names = Names()

    fun assemble(source: String): AssemblyResult {
        if (source.length > AssemblyLimits.SOURCE_CHARACTERS) {
            val message = messages.sourceTooLong(AssemblyLimits.SOURCE_CHARACTERS)
            sink.error(AssemblyError.SOURCE_TOO_LONG, Token("", 1, 1), message)
            return rejected()
        }
        val placer = CommandPlacer(sink, messages)
        val reader = AssemblyLineReader(sink, messages)
        source.lineSequence().forEachIndexed { index, line ->
            names.read(line)
            reader.read(line, index + 1)?.let { placer.place(it) }
        }
        val chunks = placer.finish()
        val encoder = CommandEncoder(sink, messages, target, chunks)
        val image = chunks.map { Chunk(it.id, encoder.encode(it)) }
        warnAbout(image)
        return if (sink.hasErrors) rejected() else assembled(image, chunks)
    }

    private fun warnAbout(chunks: List<Chunk>) {
        val start = Token("", 1, 1)
        if (chunks.none { it.id == ChunkId.MAIN }) {
            sink.warn(AssemblyError.NO_MAIN_TASK, start, messages.noMainTask())
        }
        val size = chunks.sumOf { it.code.size }
        if (size > FirmwareLimits.PROGRAM_MEMORY) {
            val message = imageMessages.largeProgram(size, FirmwareLimits.PROGRAM_MEMORY)
            sink.warn(AssemblyError.LARGE_PROGRAM, start, message)
        }
    }

    private fun rejected() = AssemblyResult.Failure(sink.inSourceOrder(Severity.ERROR))

    private fun assembled(chunks: List<Chunk>, placed: List<AssembledChunk>): AssemblyResult {
        val ordered = chunks.sortedWith(compareBy({ it.id.kind == ChunkKind.TASK }, { it.id.number }))
        val image = RcxImage(target, ordered, names.symbols(ordered.map { it.id }))
        val lines = placed.associate { chunk -> chunk.id to chunk.commands.map { CodeLine(it.address, it.word.line) } }
        return AssemblyResult.Success(image, LineTable(lines), sink.inSourceOrder(Severity.WARNING))
    }
}
