package robotran.build.wasm

/** How many [parameters] and [results] a function has. */
internal class FunctionType(val parameters: Int, val results: Int) {
    companion object {
        private const val FUNCTION_TYPE = 0x60

        /** Reads a type of a module without garbage collection. */
        fun read(reader: WasmReader): FunctionType {
            require(reader.byte() == FUNCTION_TYPE) { "The module has types that are no functions." }
            return FunctionType(reader.vector { reader.byte() }.size, reader.vector { reader.byte() }.size)
        }
    }
}

/** A global with a constant of its [type], which also says whether it can change. */
internal class GlobalDefinition(val type: ByteArray, val initialValue: ByteArray) {
    companion object {
        private const val I32_CONST = 0x41
        private const val END = 0x0b

        /** Reads a global that is a 32-bit integer. */
        fun read(reader: WasmReader): GlobalDefinition {
            val type = reader.take(2)
            val value = reader.copy {
                require(reader.byte() == I32_CONST) { "The module has globals that are no 32-bit integers." }
                reader.number()
                require(reader.byte() == END) { "A global is not a constant." }
            }
            return GlobalDefinition(type, value)
        }
    }
}
