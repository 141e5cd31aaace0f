package robotran.hublink.program

import robotran.hublink.HubError
import robotran.hublink.fourBytes
import robotran.hublink.u32

/**
 * A compiled module of a program.
 *
 * @property name what `import` calls it.
 */
class HubModule(val name: String, val mpy: ByteArray) {
    init {
        require(name.isNotEmpty() && '\u0000' !in name) { "a module needs a name" }
    }

    companion object {
        /** The name that every firmware takes for the first module. */
        const val MAIN = "__main__"
    }
}

/** A program for a hub. The first of its [modules] is the one that runs. */
class HubProgram(val modules: List<HubModule>) {
    init {
        require(modules.isNotEmpty()) { "a program has a module" }
    }

    /** A program of one module. */
    constructor(mpy: ByteArray) : this(listOf(HubModule(HubModule.MAIN, mpy)))

    /** As it is sent, the format "multi-mpy6": of each module its size, its name, a zero byte, its bytes. */
    val bytes: ByteArray by lazy {
        modules.map { fourBytes(it.mpy.size) + it.name.encodeToByteArray() + 0 + it.mpy }.reduce(ByteArray::plus)
    }

    /**
     * Why no hub could run it: the hub itself would say so only at the start, without a word on the reason. Null if nothing
     * is wrong with it.
     */
    fun mistake(): HubError? = modules.firstNotNullOfOrNull { mistakeOf(it) }

    private fun mistakeOf(module: HubModule): HubError? {
        val file = MpyFile.read(module.mpy) ?: return HubError.NotAProgram
        val isForOthers = file.nativeCode || file.smallIntegerBits > SMALL_INTEGER_BITS
        return if (isForOthers) HubError.NotAProgram else file.longNumbers.firstOrNull()?.let(HubError::NumberTooLarge)
    }

    companion object {
        private const val SMALL_INTEGER_BITS = 31

        /**
         * Reads a file: [bytes] as [HubProgram.bytes] has them, or a single module. Null if it is neither; what the modules
         * hold is not looked at.
         */
        fun read(bytes: ByteArray): HubProgram? {
            if (MpyFile.read(bytes) != null) return HubProgram(bytes)
            val modules = mutableListOf<HubModule>()
            var place = 0
            while (place < bytes.size) {
                val nameEnd =
                    (place + Int.SIZE_BYTES until bytes.size).firstOrNull { bytes[it] == 0.toByte() } ?: return null
                val name = bytes.decodeToString(place + Int.SIZE_BYTES, nameEnd)
                val end = nameEnd + 1 + bytes.u32(place)
                if (name.isEmpty() || end > bytes.size) return null
                modules += HubModule(name, bytes.copyOfRange(nameEnd + 1, end.toInt()))
                place = end.toInt()
            }
            return if (modules.isEmpty()) null else HubProgram(modules)
        }
    }
}
