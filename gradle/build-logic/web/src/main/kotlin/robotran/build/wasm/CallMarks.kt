package robotran.build.wasm

/**
 * [module] with a global for each function that it defines, exported as `called N`, which becomes 1 when the function
 * is called.
 */
internal fun withCallMarks(module: WasmModule): WasmModule {
    val globals = module.entries(WasmModule.GLOBAL) { GlobalDefinition.read(this) }
    val bodies = module.bodies
    val marks = bodies.indices.map { globals.size + it }
    val exports = bodies.indices.map {
        WasmWriter().name("called $it").byte(WasmModule.GLOBALS).number(marks[it]).bytes()
    }
    val marked = bodies.mapIndexed { index, body ->
        val reader = WasmReader(body)
        val locals = reader.copy {
            reader.vector {
                reader.number()
                reader.byte()
            }
        }
        val mark = WasmWriter().constant(1).byte(GLOBAL_SET).number(marks[index]).bytes()
        WasmWriter().sized(locals + mark + reader.rest()).bytes()
    }
    return module.with(
        mapOf(
            WasmModule.GLOBAL to WasmModule.vector(globals.map { it.type + it.initialValue } + bodies.map { MARK }),
            WasmModule.EXPORT to module.withMore(WasmModule.EXPORT, exports),
            WasmModule.CODE to WasmModule.vector(marked),
        ),
    )
}

/** A 32-bit integer that can change and is 0 at first. */
private val MARK = byteArrayOf(0x7f, 1, 0x41, 0, 0x0b)
private const val GLOBAL_SET = 0x24
