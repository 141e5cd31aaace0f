package robotran.build.wasm

/**
 * [module] with a byte for each function that it defines, which becomes 1 when the function is called: a memory of
 * their own, exported as `called`.
 */
internal fun withCallMarks(module: WasmModule): WasmModule {
    val memories = WasmContents(module).run { importsOf(IndexSpace.MEMORY).size + definedIn(IndexSpace.MEMORY).count() }
    val bodies = module.bodies
    val pages = bodies.size / PAGE + 1
    val memory = WasmWriter().byte(0).number(pages).bytes()
    val export = WasmWriter().name("called").byte(IndexSpace.MEMORY.kind).number(memories).bytes()
    val marked = bodies.mapIndexed { index, body ->
        val reader = WasmReader(body)
        val locals = reader.copy { sameCopier(reader).locals() }
        val mark = WasmWriter().constant(0).constant(1).byte(STORE_BYTE, NAMED_MEMORY).number(memories).number(index)
        WasmWriter().sized(locals + mark.bytes() + reader.rest()).bytes()
    }
    return module.with(
        mapOf(
            WasmModule.MEMORY to module.withMore(WasmModule.MEMORY, listOf(memory)),
            WasmModule.EXPORT to module.withMore(WasmModule.EXPORT, listOf(export)),
            WasmModule.CODE to WasmModule.vector(marked),
        ),
    )
}

private const val PAGE = 65_536
private const val STORE_BYTE = 0x3a

/** An alignment of one byte in a memory that is named. */
private const val NAMED_MEMORY = 0x40
