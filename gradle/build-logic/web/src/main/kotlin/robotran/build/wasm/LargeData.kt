package robotran.build.wasm

/**
 * A part of a module's memory that has its initial value from the data segment [index]: [size] bytes from [address] on.
 */
internal class LargeData(val index: Int, val address: Int, val size: Int) {
    /** The addresses of its blocks of [BLOCK] bytes, of which the last may be shorter. */
    val blocks: List<Int> get() = (address until address + size step BLOCK).toList()

    companion object {
        /**
         * Bytes. Smaller data are tables and texts for all that a program does; what is larger and is not read is of use
         * to one task, such as a dictionary of words.
         */
        const val LARGE = 32 * 1024

        /** Bytes whose readings are not distinguished: 2 to the power of [BLOCK_BITS]. */
        const val BLOCK = 4 * 1024
        const val BLOCK_BITS = 12
        private const val I32_CONST = 0x41
        private const val END = 0x0b

        /** The active data segments of [module] that have at least [LARGE] bytes and stand at a constant address. */
        fun of(module: WasmModule): List<LargeData> {
            val contents = WasmContents(module)
            return contents.definedIn(IndexSpace.DATA).filter { contents.isActive(IndexSpace.DATA, it) }.mapNotNull {
                val segment = WasmReader(contents.definition(IndexSpace.DATA, it))
                val isOfFirstMemory = segment.number() and WasmCopier.EXPLICIT == 0
                if (!isOfFirstMemory || segment.byte() != I32_CONST) return@mapNotNull null
                val address = segment.signed()
                segment.byte()
                LargeData(it, address, segment.number()).takeIf { data -> data.size >= LARGE }
            }
        }

        /**
         * [module] with segments of their own for each sequence of [blocks] that has at least [LARGE] bytes, and the
         * indices of these segments. They are the last ones, so the others keep theirs.
         */
        fun cut(module: WasmModule, blocks: Set<Int>): Pair<WasmModule, Set<Int>> {
            val segments = module.entries(WasmModule.DATA) { copy { sameCopier(this).data() } }.toMutableList()
            val late = mutableListOf<ByteArray>()
            for (data in of(module)) {
                val unread = sequences(data.blocks.filter { it in blocks })
                    .map { it.first - data.address..minOf(it.last - data.address, data.size - 1) }
                    .filter { it.last - it.first + 1 >= LARGE }
                val bytes = segments[data.index].run { copyOfRange(size - data.size, size) }

                fun segment(places: IntRange): ByteArray = WasmWriter().byte(0).constant(data.address + places.first)
                    .byte(END).sized(bytes.sliceArray(places)).bytes()
                val starts = listOf(0) + unread.map { it.last + 1 }
                val ends = unread.map { it.first } + data.size
                val read = starts.zip(ends) { start, end -> segment(start until end) }
                segments[data.index] = read.first()
                segments += read.drop(1)
                late += unread.map(::segment)
            }
            if (late.isEmpty()) return module to emptySet()
            check(module[WasmModule.DATA_COUNT] == null) { "The functions of the module may name its data segments." }
            val all = module.with(mapOf(WasmModule.DATA to WasmModule.vector(segments + late)))
            return all to (segments.size until segments.size + late.size).toSet()
        }

        /** The ranges of addresses that [blocks], in ascending order, cover together. */
        fun sequences(blocks: List<Int>): List<IntRange> {
            val starts = blocks.filterIndexed { place, block -> place == 0 || blocks[place - 1] + BLOCK != block }
            val ends = blocks.filterIndexed { place, block ->
                place == blocks.lastIndex ||
                    blocks[place + 1] != block + BLOCK
            }
            return starts.zip(ends) { start, end -> start until end + BLOCK }
        }
    }
}
