package robotran.build.wasm

/**
 * Marks which [data] of [module] is read: each instruction that reads the memory, and each call of the function by which
 * Emscripten copies much memory, calls a function first that sets the byte of the
 * block that is read.
 *
 * @param memory the index of the memory of the marks.
 * @param firstMark the address in it of the byte for the first block of the first of [data].
 */
internal class ReadMarks(
    private val module: WasmModule,
    private val data: List<LargeData>,
    private val memory: Int,
    private val firstMark: Int,
) {
    private val functions = module.importedFunctions
    private val ofRead = functions + module.bodies.size
    private val ofCopy = ofRead + 1
    private val copies = module.imports.filter { it.space == IndexSpace.FUNCTION }.indexOfFirst { it.name == COPY }

    /** The types of the added functions: an address and an offset give the address, and a copy's parameters themselves. */
    val types: List<ByteArray> = listOf(
        byteArrayOf(WasmTypes.FUNCTION_TYPE.toByte(), 2, I32, I32, 1, I32),
        byteArrayOf(WasmTypes.FUNCTION_TYPE.toByte(), COPIED, I32, I32, I32, COPIED, I32, I32, I32),
    )

    /** The bodies of the added functions, which follow those of the module, each without its length. */
    val added: List<ByteArray> = listOf(read(), copy())

    /** What marks the next instruction of [code]; nothing if it reads no memory. */
    fun before(code: WasmReader): ByteArray {
        when (code.byte()) {
            in LOADS -> {
                code.number() // The alignment.
                return WasmWriter().constant(code.number()).byte(CALL).number(ofRead).bytes()
            }

            CALL -> if (copies >= 0 && code.number() == copies) return WasmWriter().byte(CALL).number(ofCopy).bytes()
        }
        return ByteArray(0)
    }

    private fun read(): ByteArray {
        val writer = WasmWriter().byte(1, 1, I32.toInt())
        writer.byte(LOCAL_GET, 0, LOCAL_GET, 1, ADD, LOCAL_SET, PLACE)
        var mark = firstMark
        for (each in data) {
            val distance = WasmWriter().byte(LOCAL_GET, PLACE).constant(each.address).byte(SUBTRACT).bytes()
            writer.raw(distance).constant(each.size).byte(IS_LESS_UNSIGNED, IF, NO_RESULT)
            writer.raw(distance).constant(LargeData.BLOCK_BITS).byte(SHIFT_RIGHT)
            writer.raw(setByte(memory, mark)).byte(END)
            mark += each.blocks.size
        }
        return writer.byte(LOCAL_GET, 0, END).bytes()
    }

    private fun copy(): ByteArray = WasmWriter().byte(0)
        .byte(LOCAL_GET, 1).constant(0).byte(CALL).number(ofRead).byte(DROP)
        .byte(LOCAL_GET, 0, LOCAL_GET, 1, LOCAL_GET, 2, END).bytes()

    companion object {
        /** Instructions that set the byte at [address] in the memory with the index [memory] to 1. */
        fun markOf(memory: Int, address: Int): ByteArray = WasmWriter().constant(0).bytes() + setByte(memory, address)

        /** The same, for [address] and a number before it. */
        private fun setByte(memory: Int, address: Int): ByteArray =
            WasmWriter().constant(1).byte(STORE_BYTE, NAMED_MEMORY).number(memory).number(address).bytes()

        /** Emscripten's function in the script, with the parameters target, source and length. */
        private const val COPY = "emscripten_memcpy_js"
        private const val COPIED: Byte = 3
        private const val I32: Byte = 0x7f

        /** The local with the place that is read. */
        private const val PLACE = 2
        private val LOADS = 0x28..0x35
        private const val STORE_BYTE = 0x3a

        /** An alignment of one byte in a memory that is named. */
        private const val NAMED_MEMORY = 0x40
        private const val IF = 0x04
        private const val NO_RESULT = 0x40
        private const val END = 0x0b
        private const val CALL = 0x10
        private const val DROP = 0x1a
        private const val LOCAL_GET = 0x20
        private const val LOCAL_SET = 0x21
        private const val IS_LESS_UNSIGNED = 0x49
        private const val ADD = 0x6a
        private const val SUBTRACT = 0x6b
        private const val SHIFT_RIGHT = 0x76
    }
}
