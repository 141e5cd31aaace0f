package robotran.legofirmware.image

/** The bytes of the `.rcx` file, as NQC's own compiler writes them. */
fun RcxImage.toBytes(): ByteArray {
    val sink = ByteSink()
    RcxImageFormat.SIGNATURE.forEach { sink.byte(it.code) }
    sink.word(RcxImageFormat.VERSION)
    sink.word(chunks.size)
    sink.word(symbols.size)
    sink.byte(target.code)
    sink.byte(0)
    chunks.forEach { sink.write(it) }
    symbols.forEach { sink.write(it) }
    return sink.toByteArray()
}

private fun ByteSink.write(chunk: Chunk) {
    byte(chunk.id.kind.code)
    byte(chunk.id.number)
    word(chunk.code.size)
    for (address in 0 until chunk.code.size) byte(chunk.code[address])
    repeat(RcxImageFormat.padded(chunk.code.size) - chunk.code.size) { byte(0) }
}

private fun ByteSink.write(symbol: Symbol) {
    byte(symbol.kind.code)
    byte(symbol.number)
    byte(symbol.name.length + 1)
    byte(0)
    symbol.name.forEach { byte(it.code) }
    byte(0)
}
