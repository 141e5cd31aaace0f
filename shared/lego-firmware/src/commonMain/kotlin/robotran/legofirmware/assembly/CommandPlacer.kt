package robotran.legofirmware.assembly

import robotran.language.editDistance
import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.instructions.NumberRange
import robotran.legofirmware.listing.BYTES_MNEMONIC
import robotran.legofirmware.messages.AssemblyMessages

/** Divides lines into tasks and subroutines and gives labels and commands their addresses. */
internal class CommandPlacer(private val sink: AssemblySink, private val messages: AssemblyMessages) {
    private val chunks = linkedMapOf<ChunkId, AssembledChunk>()
    private val labelLines = mutableMapOf<String, Int>()
    private var open: AssembledChunk? = null

    fun place(line: AssemblyLine) {
        line.label?.let { define(it) }
        val word = line.word ?: return
        val name = word.text.lowercase()
        val frame = BlockDirective.entries.find { name == it.word || name == it.end }
        when {
            frame == null -> command(word, name, line.operands)
            name == frame.word -> begin(frame, word, line.operands)
            else -> end(frame, word)
        }
    }

    fun finish(): List<AssembledChunk> {
        open?.let { notClosed(it) }
        return chunks.values.toList()
    }

    private fun define(label: Token) {
        val chunk = open
        val firstLine = labelLines[label.text]
        when {
            chunk == null -> sink.error(AssemblyError.OUTSIDE_CHUNK, label, messages.outsideChunk(label.text))

            firstLine != null -> {
                sink.error(AssemblyError.LABEL_TWICE, label, messages.labelTwice(short(label.text), firstLine))
            }

            else -> {
                labelLines[label.text] = label.line
                chunk.labels[label.text] = chunk.size
            }
        }
    }

    private fun begin(frame: BlockDirective, word: Token, operands: List<Token>) {
        open?.let { notClosed(it) }
        open = null
        val place = operands.singleOrNull()?.takeIf { it.text.isNotEmpty() }
        if (place == null) {
            val message = messages.wrongNumberCount("${frame.word} number")
            sink.error(AssemblyError.WRONG_NUMBER_COUNT, word, message)
        }
        val range = NumberRange("number", 0 until frame.kind.limit)
        val number = place?.let { CheckedNumbers(sink, messages).number(it, range, "${frame.word} number") }
        val id = ChunkId(frame.kind, number ?: -1)
        val chunk = AssembledChunk(id, frame, word)
        open = chunk
        if (number == null) return
        if (id in chunks) {
            sink.error(AssemblyError.CHUNK_TWICE, word, messages.chunkTwice(frame.word, number))
        } else {
            chunks[id] = chunk
        }
    }

    private fun end(frame: BlockDirective, word: Token) {
        val expected = open?.frame
        if (expected != frame) {
            val message = messages.wrongEnd(word.text, expected?.end)
            sink.error(AssemblyError.WRONG_END, word, message, expected?.end)
        }
        open = null
    }

    private fun notClosed(chunk: AssembledChunk) {
        val message = messages.notClosed(chunk.frame.word, chunk.frame.end)
        sink.error(AssemblyError.NOT_CLOSED, chunk.start, message)
    }

    private fun command(word: Token, name: String, operands: List<Token>) {
        val content = if (name == BYTES_MNEMONIC) bytes(word, operands) else instruction(word, name, operands)
        val chunk = open
        when {
            content == null -> return
            chunk == null -> sink.error(AssemblyError.OUTSIDE_CHUNK, word, messages.outsideChunk(short(word.text)))

            chunk.size + content.size > FirmwareLimits.CHUNK_BYTES -> {
                sink.error(AssemblyError.CODE_TOO_LONG, chunk.start, messages.codeTooLong(FirmwareLimits.CHUNK_BYTES))
            }

            else -> chunk.add(word, content)
        }
    }

    private fun bytes(word: Token, operands: List<Token>): AssembledChunk.Content? {
        if (operands.isEmpty()) {
            sink.error(
                AssemblyError.WRONG_NUMBER_COUNT,
                word,
                messages.wrongNumberCount(CommandForm.BYTES_FORM),
            )
            return null
        }
        val numbers = CheckedNumbers(sink, messages)
        val bytes = operands.map { numbers.number(it, NumberRange.BYTE, CommandForm.BYTES_FORM) ?: 0 }
        return AssembledChunk.Content.Bytes(bytes)
    }

    private fun instruction(word: Token, name: String, operands: List<Token>): AssembledChunk.Content? {
        val forms = CommandForm.of(name)
        if (forms.isEmpty()) {
            val suggestion = alike(name, CommandForm.words)
            val message = messages.unknownCommand(short(word.text), suggestion)
            sink.error(AssemblyError.UNKNOWN_COMMAND, word, message, suggestion)
            return null
        }
        val form = forms.find { it.places.size == operands.size }
        if (form == null) {
            val message = messages.wrongNumberCount(forms.last().toString())
            sink.error(AssemblyError.WRONG_NUMBER_COUNT, word, message)
        }
        return AssembledChunk.Content.Instruction(form ?: forms.last(), operands.takeIf { form != null })
    }
}

private const val LONGEST_SHOWN = 40

/** A part of the text for a message. */
internal fun short(text: String): String = if (text.length > LONGEST_SHOWN) text.take(LONGEST_SHOWN) + "…" else text

private const val MOST_ERRORS = 2
private const val LONGEST_ALIKE = 30

/** The word that [typed] is most probably meant to be; null if none is spelled alike. */
internal fun alike(typed: String, words: Collection<String>): String? {
    if (typed.length > LONGEST_ALIKE) return null
    val allowed = if (typed.length <= MOST_ERRORS + 1) 1 else MOST_ERRORS
    return words.filter { it.length <= LONGEST_ALIKE }.map { it to editDistance(typed, it) }
        .filter { it.second <= allowed }.minByOrNull { it.second }?.first
}
