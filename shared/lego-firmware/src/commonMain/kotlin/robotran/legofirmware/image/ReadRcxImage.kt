package robotran.legofirmware.image

/** Reads an `.rcx` file (RCXI). Reserved bytes and what fills up a chunk are not checked, as in NQC. */
fun readRcxImage(bytes: ByteArray): RcxImageResult = try {
    RcxImageReader(bytes).read()
} catch (refusal: ImageRefusal) {
    RcxImageResult.Failure(refusal.fault)
}

/** Aborts reading; caught in [readRcxImage]. */
private class ImageRefusal(val fault: ImageFault) : RuntimeException()

private class RcxImageReader(private val bytes: ByteArray) {
    private var position = 0
    private val warnings = mutableListOf<ImageFault>()
    private val bytesLeft: Int get() = bytes.size - position

    fun read(): RcxImageResult {
        if (bytes.size > FirmwareLimits.IMAGE_BYTES) refuse(ImageFault.TooLarge(bytes.size))
        if (bytes.size < RcxImageFormat.HEADER_BYTES) refuse(ImageFault.NotAnImage)
        if (RcxImageFormat.SIGNATURE.any { byte() != it.code }) refuse(ImageFault.NotAnImage)
        val version = word()
        if (version > RcxImageFormat.VERSION) refuse(ImageFault.NewerVersion(version))
        val chunkCount = word()
        val symbolCount = word()
        val targetCode = byte()
        val target = FirmwareTarget.of(targetCode) ?: refuse(ImageFault.OtherBrick(targetCode))
        position = RcxImageFormat.HEADER_BYTES
        val chunks = readChunks(chunkCount)
        if (symbolCount > FirmwareLimits.SYMBOLS) refuse(ImageFault.TooManySymbols(symbolCount))
        val symbols = readSymbols(symbolCount, chunks.keys)
        if (ChunkId.MAIN !in chunks) warnings += ImageFault.NoMainTask
        val image = RcxImage(target, chunks.values.toList(), symbols)
        if (image.codeSize > FirmwareLimits.PROGRAM_MEMORY) warnings += ImageFault.LargeProgram(image.codeSize)
        return RcxImageResult.Success(image, warnings)
    }

    /** Numbers above the limits and second chunks are refused, so the loop is short whatever [count] is. */
    private fun readChunks(count: Int): Map<ChunkId, Chunk> {
        val chunks = linkedMapOf<ChunkId, Chunk>()
        repeat(count) {
            val chunk = readChunk()
            if (chunks.put(chunk.id, chunk) != null) refuse(ImageFault.ChunkTwice(chunk.id))
        }
        return chunks
    }

    private fun readChunk(): Chunk {
        if (bytesLeft < RcxImageFormat.CHUNK_HEADER_BYTES) refuse(ImageFault.ChunkCut(null))
        val type = byte()
        val kind = ChunkKind.of(type) ?: refuse(ImageFault.UnknownChunk(type))
        val id = ChunkId(kind, byte())
        if (id.number >= kind.limit) refuse(ImageFault.NumberTooHigh(id))
        val length = word()
        if (bytesLeft < length) refuse(ImageFault.ChunkCut(id))
        val code = CodeBytes(bytes.copyOfRange(position, position + length))
        position = minOf(bytes.size, position + RcxImageFormat.padded(length))
        return Chunk(id, code)
    }

    private fun readSymbols(count: Int, chunks: Set<ChunkId>): List<Symbol> {
        val symbols = mutableListOf<Symbol>()
        for (index in 0 until count) {
            if (!readSymbol(symbols, chunks)) {
                warnings += ImageFault.NamesCut(count - index)
                return symbols
            }
        }
        if (bytesLeft > 0) warnings += ImageFault.ExtraBytes(bytesLeft)
        return symbols
    }

    /** Returns false if the file ends within the symbol. */
    private fun readSymbol(symbols: MutableList<Symbol>, chunks: Set<ChunkId>): Boolean {
        if (bytesLeft < RcxImageFormat.SYMBOL_HEADER_BYTES) return false
        val kind = SymbolKind.of(byte())
        val number = byte()
        val length = byte()
        position++
        if (bytesLeft < length) return false
        val name = nameAt(position, length)
        position += length
        val owner = kind?.let { ChunkKind.of(it.code) }
        when {
            kind == null || (owner != null && ChunkId(owner, number) !in chunks) -> {
                warnings += ImageFault.NameWithoutChunk(name)
            }

            else -> symbols += Symbol(kind, number, name)
        }
        return true
    }

    private fun nameAt(start: Int, length: Int): String {
        val characters = (start until start + length).map { (bytes[it].toInt() and BYTE_MASK).toChar() }
        return characters.takeWhile { it.code != 0 }.joinToString("").take(FirmwareLimits.NAME_CHARACTERS)
    }

    private fun byte(): Int = bytes[position++].toInt() and BYTE_MASK

    private fun word(): Int = byte() or (byte() shl Byte.SIZE_BITS)

    private fun refuse(fault: ImageFault): Nothing = throw ImageRefusal(fault)

    private companion object {
        const val BYTE_MASK = 0xFF
    }
}
